// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block_solver.h>
#include <hybrid/dda/static_steps.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    constexpr double target_residual = 1e-9;
    constexpr double first_step      = 0.0156; ///< pseudo time step [s]
    constexpr double smallest_step   = 1e-5;
    constexpr double largest_step    = 1e3;



    void stop_blocks(DdaState &state)
    {
      for (BlockState &block : state.blocks)
        {
          block.velocity.setZero();
          block.acceleration.setZero();
          block.contact_acceleration.setZero();
          block.viscous_stress.setZero();
        }
    }



    /// The open-close iterations of the step under way, and what was done before.
    OpenCloseIteration::Watch watch_of_step(const StaticWatch &watch, const StaticResult &result)
    {
      return [&watch, &result](const StepResult &step) {
        return watch({result.steps,
                      result.iterations + step.iterations,
                      result.steps > 0 ? result.residual : 1.,
                      target_residual});
      };
    }
  } // namespace



  Model static_problem(const Model &model)
  {
    Model copy                = model;
    copy.joint_damping_time   = 0.;
    copy.bedrock_damping_time = 0.;
    copy.edge_loads.edges.clear();
    for (BlockProperties &block : copy.blocks)
      block.damping_time = block.loose_damping_time = 0.;
    copy.newmark             = Newmark::preset("shi");
    copy.dynamic_coefficient = 1.;
    copy.iteration.tolerance = 0.1 * target_residual;
    return copy;
  }



  StaticResult take_static_steps(const Model       &problem,
                                 DdaState          &state,
                                 const StaticPace  &pace,
                                 const StaticWatch &watch)
  {
    BlockSolver  solver(problem);
    BaseResponse base;
    base.displacement = state.base_displacement;
    StaticResult result;
    if (watch)
      solver.set_watch(watch_of_step(watch, result));

    for (double dt = first_step; result.steps < pace.maximum_steps && dt >= smallest_step;)
      {
        stop_blocks(state);
        const StepResult step = solver.solve(state, base, dt);
        result.iterations += step.iterations;
        result.stopped = step.stopped;
        if (result.stopped)
          return result;
        if (!step.converged)
          {
            dt /= 4.;
            ++result.cuts;
            continue;
          }
        state.time = -1. - dt; // failures of these steps get a negative time
        solver.accept(state);
        ++result.steps;
        result.residual     = step.unbalanced;
        result.moving_block = step.largest_block;
        if (result.residual <= target_residual)
          {
            result.equilibrium  = true;
            result.moving_block = -1;
            break;
          }
        dt = std::min(largest_step, pace.growth * dt);
      }
    stop_blocks(state);
    return result;
  }
} // namespace hybrid::dda
