// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block_energy.h>
#include <hybrid/dda/block_solver.h>
#include <hybrid/dda/start_accelerations.h>
#include <hybrid/dda/static_stage.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    constexpr double target_residual = 1e-9;
    constexpr double first_step      = 0.0156; ///< pseudo time step [s]
    constexpr double smallest_step   = 1e-5;
    constexpr double largest_step    = 1e3;
    constexpr int    maximum_steps   = 400;
    constexpr double growth          = 2.;



    void stop_blocks(DdaState &state)
    {
      for (BlockState &block : state.blocks)
        {
          block.velocity.setZero();
          block.acceleration.setZero();
          block.contact_acceleration.setZero();
          block.strain_rate.setZero();
        }
    }



    /// The same problem without damping, solved more exactly than a dynamic step, at any choice
    /// of scheme with contacts and all other forces balanced at the end of the step.
    Model static_model(const Model &model, const bool held)
    {
      Model copy                = model;
      copy.joint_damping_time   = 0.;
      copy.bedrock_damping_time = 0.;
      copy.hold_bedrock         = true;
      copy.edge_loads.edges.clear();
      for (BlockProperties &block : copy.blocks)
        block.damping_time = 0.;
      copy.newmark             = Newmark::preset("shi");
      copy.dynamic_coefficient = 1.;
      copy.iteration.tolerance = 0.1 * target_residual;
      if (held)
        {
          for (Joint &joint : copy.joints)
            joint.law = joint.law.with(JointStrength::unlimited_bond());
          for (ContactLaw &contact : copy.block_contact)
            contact.law = contact.law.with(JointStrength::unlimited_friction());
          for (ContactLaw &contact : copy.base_contact)
            contact.law = contact.law.with(JointStrength::unlimited_friction());
        }
      return copy;
    }
  } // namespace



  StaticResult
  settle(const Model &model, DdaState &state, const bool held, const StaticWatch &watch)
  {
    const Model  problem = static_model(model, held);
    BlockSolver  solver(problem);
    BaseResponse base;
    base.displacement       = state.base_displacement;
    const double start_time = state.time;
    const auto   start      = state.blocks;
    StaticResult result;
    if (watch)
      solver.set_watch([&watch, &result](const StepResult &step) {
        return watch({result.steps,
                      result.iterations + step.iterations,
                      result.steps > 0 ? result.residual : 1.,
                      target_residual});
      });

    for (double dt = first_step; result.steps < maximum_steps && dt >= smallest_step;)
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
        state.time = -1. - dt; // failures of this stage get a negative time
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
        dt = std::min(largest_step, growth * dt);
      }

    stop_blocks(state);
    bear_static_forces(model, state);
    start_accelerations(model, state);
    for (std::size_t b = 0; b < state.blocks.size(); ++b)
      result.largest_displacement = std::max(result.largest_displacement,
                                             (state.blocks[b].centroid - start[b].centroid).norm());
    state.time         = start_time;
    state.static_force = state.base_force;
    state.energy       = held_energy(model, state);
    return result;
  }
} // namespace hybrid::dda
