// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/static_steps.h>
#include <hybrid/dda/statics/stick_predictor_steps.h>

namespace hybrid::dda
{
  StickPredictorSteps::StickPredictorSteps(const Model                     &problem,
                                           const OpenCloseIteration::Watch &watch)
    : held(with_unlimited_friction(problem))
    , eased(problem)
    , hold_solver(held)
    , solver(eased)
  {
    eased.iteration.regularises_sliding = true;
    hold_solver.set_watch(watch);
    solver.set_watch(watch);
  }



  StepResult StickPredictorSteps::hold(const DdaState           &state,
                                       const FoundationResponse &foundation,
                                       const double              dt)
  {
    DdaState         copy   = state;
    const StepResult result = hold_solver.solve(copy, foundation, dt);
    has_guess               = result.converged;
    return result;
  }



  StepResult
  StickPredictorSteps::solve(DdaState &state, const FoundationResponse &foundation, const double dt)
  {
    return solver.solve(state,
                        foundation,
                        dt,
                        has_guess ? &hold_solver.solved_step().increments() : nullptr);
  }
} // namespace hybrid::dda
