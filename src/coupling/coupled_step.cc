// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/coupled_step.h>

#include <cassert>
#include <chrono>

namespace hybrid::coupling
{
  namespace
  {
    /// Adds the time of a scope to a sum.
    class Stopwatch
    {
    public:
      explicit Stopwatch(double &seconds)
        : sum(seconds)
        , start(std::chrono::steady_clock::now())
      {}

      ~Stopwatch()
      {
        sum += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      }

    private:
      double                                     &sum;
      const std::chrono::steady_clock::time_point start;
    };
  } // namespace



  CoupledStep::CoupledStep(dda::BlockSolver     *block_solver,
                           Base                 *block_base,
                           continuum::Continuum *bedrock)
    : blocks(block_solver)
    , base(block_base)
    , continuum(bedrock)
  {
    assert(blocks == nullptr || base != nullptr);
  }



  dda::StepResult CoupledStep::solve(CoupledState &state, const double dt)
  {
    dda::StepResult result;
    if (blocks == nullptr)
      {
        const Stopwatch watch(elapsed.continuum);
        if (continuum != nullptr)
          continuum->step(state.continuum, dt);
        result.converged = true;
        state.time += dt;
        return result;
      }

    const dda::BaseResponse *response = nullptr;
    {
      const Stopwatch watch(elapsed.continuum);
      response = &base->predict(state.continuum, dt);
    }
    {
      const Stopwatch watch(elapsed.blocks);
      result = blocks->solve(state.blocks, *response, dt);
      if (!result.converged)
        return result;
      blocks->accept(state.blocks);
    }
    const Stopwatch watch(elapsed.continuum);
    base->correct(state.continuum,
                  dt,
                  blocks->solved_step().base_displacement(),
                  blocks->solved_step().base_force_increment());
    state.time += dt;
    return result;
  }
} // namespace hybrid::coupling
