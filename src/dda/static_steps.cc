// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block_solver.h>
#include <hybrid/dda/static_steps.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace hybrid::dda
{
  namespace
  {
    constexpr double target_residual = 1e-9;
    constexpr double first_step      = 0.0156; ///< pseudo time step [s]
    constexpr double smallest_step   = 1e-5;
    constexpr double largest_step    = 1e3;
    constexpr int    hopeless_cuts   = 4;  ///< of plain steps; of the first one, one
    constexpr double great_step      = 1.; ///< in which inertia hardly counts [s]



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



    Model with_unlimited_friction(Model model)
    {
      for (ContactLaw &contact : model.block_contact)
        contact.law = contact.law.with(JointStrength::unlimited_friction());
      for (ContactLaw &contact : model.base_contact)
        contact.law = contact.law.with(JointStrength::unlimited_friction());
      return model;
    }



    /**
     * Steps for a mass in which hundreds of contacts reach their friction limit at once: each
     * begins where contacts that never slide would bring the blocks, sliding is eased, and the
     * first steps are solved less exactly. They are great from the start: on the way of small ones
     * the upper blocks hardly weigh on the lower ones, and contacts without force open and close.
     */
    class StepsFromHold
    {
    public:
      StepsFromHold(const Model &problem, const OpenCloseIteration::Watch &watch)
        : held(with_unlimited_friction(problem))
        , eased(problem)
        , last_tolerance(problem.iteration.tolerance)
        , hold(held)
        , solver(eased)
      {
        eased.iteration.eases_sliding = true;
        hold.set_watch(watch);
        solver.set_watch(watch);
      }

      StepResult
      solve(DdaState &state, const BaseResponse &base, const double dt, const double residual)
      {
        DdaState         copy  = state;
        const StepResult first = hold.solve(copy, base, dt);
        if (first.stopped)
          return first;
        const std::vector<Vec6> &guess = hold.solved_step().increments();
        eased.iteration.tolerance      = std::max(last_tolerance, 1e-3 * residual);
        StepResult result = solver.solve(state, base, dt, first.converged ? &guess : nullptr);
        result.iterations += first.iterations;
        return result;
      }

      void accept(DdaState &state) const
      {
        solver.accept(state);
      }

    private:
      Model        held, eased;
      const double last_tolerance;
      BlockSolver  hold, solver;
    };
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
    BaseResponse base;
    base.displacement = state.base_displacement;
    StaticResult                    result;
    const OpenCloseIteration::Watch watch_step =
      watch ? watch_of_step(watch, result) : OpenCloseIteration::Watch();
    BlockSolver solver(problem);
    solver.set_watch(watch_step);
    std::optional<StepsFromHold> from_hold; // once plain steps have not converged

    for (double dt = first_step; result.steps < pace.maximum_steps && dt >= smallest_step;)
      {
        stop_blocks(state);
        const StepResult step =
          from_hold ? from_hold->solve(state, base, dt, result.steps > 0 ? result.residual : 1.)
                    : solver.solve(state, base, dt);
        result.iterations += step.iterations;
        result.stopped = step.stopped;
        if (result.stopped)
          return result;
        if (!step.converged)
          {
            ++result.cuts;
            dt /= 4.;
            if (from_hold || (result.steps > 0 && result.cuts < hopeless_cuts))
              continue;
            from_hold.emplace(problem, watch_step);
            dt = great_step;
            continue;
          }
        state.time = -1. - dt; // failures of these steps get a negative time
        if (from_hold)
          from_hold->accept(state);
        else
          solver.accept(state);
        ++result.steps;
        result.residual     = std::max(step.unbalanced, step.residual);
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
