// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/step/block_solver.h>

namespace hybrid::dda
{
  /**
   * Static steps for loose masses in which hundreds of contacts reach their friction limit at once.
   *
   * Each begins where contacts that never slide would bring the blocks, and sliding is eased
   * (SlidingRegularisation). They are great from the start: on the way of small ones the upper
   * blocks hardly weigh on the lower ones, and contacts without force open and close.
   */
  class StickPredictorSteps
  {
  public:
    /// @param watch may be empty
    StickPredictorSteps(const Model &problem, const OpenCloseIteration::Watch &watch);

    // The solvers refer to the models beside them.
    StickPredictorSteps(const StickPredictorSteps &)            = delete;
    StickPredictorSteps &operator=(const StickPredictorSteps &) = delete;

    /// Find where contacts that never slide would bring the blocks. @return how it went
    StepResult hold(const DdaState &state, const FoundationResponse &foundation, double dt);

    /// Solve the step from there.
    StepResult solve(DdaState &state, const FoundationResponse &foundation, double dt);

    /// Make the solved step the new state.
    void accept(DdaState &state)
    {
      solver.accept(state);
    }

    PartTimes part_times() const
    {
      PartTimes times = solver.part_times();
      return times += hold_solver.part_times();
    }

  private:
    Model       held, eased;
    BlockSolver hold_solver, solver;
    bool        has_guess = false; ///< the hold of this step converged
  };
} // namespace hybrid::dda
