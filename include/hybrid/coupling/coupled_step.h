// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/coupling/coupled_state.h>
#include <hybrid/coupling/foundation.h>
#include <hybrid/dda/step/block_solver.h>

namespace hybrid::coupling
{
  /// Wall time of the parts of a step, summed [s].
  struct StepTimings
  {
    long   slip_rounds = 0;  ///< solutions of blocks that slip of bedding planes asked for besides
    double continuum   = 0.; ///< forward and backward substitution
    double blocks      = 0.; ///< contact search, open-close iteration
  };


  /**
   * One step of everything: blocks and base together, or only one of them.
   *
   * The result says whether the step converged; if not, the state is that of
   * before (but for the list of contact candidates, which depends on
   * geometry alone).
   */
  class CoupledStep
  {
  public:
    /// @param blocks may be nullptr (site response); @param continuum may be nullptr (pure DDA);
    /// with blocks there is always a base. All must outlive the step.
    CoupledStep(dda::BlockSolver *blocks, Foundation *foundation, continuum::Continuum *continuum);

    dda::StepResult solve(CoupledState &state, double dt);

    const StepTimings &timings() const
    {
      return elapsed;
    }

    /// Timings so far, for the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    /// Blocks and surface together; iterations add up in @p result.
    void solve_blocks(CoupledState                  &state,
                      const dda::FoundationResponse &response,
                      double                         dt,
                      dda::StepResult               &result);

    dda::BlockSolver     *blocks;
    Foundation           *foundation;
    continuum::Continuum *continuum;
    StepTimings           elapsed;

    continuum::SurfaceForce surface_force; ///< of the last step, kept for its memory alone
  };
} // namespace hybrid::coupling
