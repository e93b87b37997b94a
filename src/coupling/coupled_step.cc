// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/coupled_step.h>
#include <hybrid/restart/archive.h>
#include <hybrid/scene/stopwatch.h>

#include <cassert>

namespace hybrid::coupling
{
  namespace
  {
    /// Solutions of the blocks with new slip of bedding planes, before the step is cut.
    constexpr int max_slip_rounds = 30;
  } // namespace



  CoupledStep::CoupledStep(dda::BlockSolver     *block_solver,
                           Foundation           *of_blocks,
                           continuum::Continuum *bedrock)
    : blocks(block_solver)
    , foundation(of_blocks)
    , continuum(bedrock)
  {
    assert(blocks == nullptr || foundation != nullptr);
  }



  void CoupledStep::solve_blocks(CoupledState                  &state,
                                 const dda::FoundationResponse &response,
                                 const double                   dt,
                                 dda::StepResult               &result)
  {
    const Stopwatch       watch(elapsed.blocks);
    const dda::StepResult found      = blocks->solve(state.blocks, response, dt);
    const int             iterations = result.iterations, inner = result.solver_iterations;
    const int             factorizations = result.factorizations, few = result.few_iterations;
    result = found;
    result.iterations += iterations;
    result.few_iterations += few;
    result.solver_iterations += inner;
    result.factorizations += factorizations;
  }



  dda::StepResult CoupledStep::solve(CoupledState &state, const double dt)
  {
    dda::StepResult result;
    if (blocks == nullptr)
      {
        const Stopwatch watch(elapsed.continuum);
        result.converged = continuum == nullptr || continuum->step(state.continuum, dt);
        if (result.converged)
          state.time += dt;
        return result;
      }

    const dda::FoundationResponse *response = nullptr;
    {
      const Stopwatch watch(elapsed.continuum);
      response = &foundation->predict(state, dt);
    }
    auto slip = continuum::SlipStatus::changed;
    for (int round = 0; slip == continuum::SlipStatus::changed; ++round)
      {
        elapsed.slip_rounds += round > 0;
        solve_blocks(state, *response, dt, result);
        if (!result.converged)
          return result;
        const Stopwatch watch(elapsed.continuum);
        slip = foundation->solve_slip(state, dt, blocks->solved_step().foundation_displacement());
        if (slip == continuum::SlipStatus::failed || round == max_slip_rounds)
          {
            result.converged = false;
            return result;
          }
      }
    {
      const Stopwatch watch(elapsed.blocks);
      blocks->accept(state.blocks);
    }
    const Stopwatch                watch(elapsed.continuum);
    const dda::OpenCloseIteration &solved = blocks->solved_step();
    surface_force.all                     = solved.foundation_force_increment();
    surface_force.contacts                = solved.foundation_contact_increment();
    surface_force.ended = state.blocks.foundation_contact_force - state.blocks.static_contact_force;
    foundation->correct(state, dt, solved.foundation_displacement(), surface_force);
    state.time += dt;
    return result;
  }



  void CoupledStep::serialize(restart::Archive &archive)
  {
    auto &[slip_rounds, continuum_time, blocks_time] = elapsed;
    archive(slip_rounds, continuum_time, blocks_time);
  }
} // namespace hybrid::coupling
