// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::dda
{
  /// What became of one step of the blocks.
  struct StepResult
  {
    bool   converged          = false; ///< if not, nothing was changed: cut the step
    bool   stopped            = false; ///< by whoever watches the iteration
    int    iterations         = 0;     ///< of the open-close iteration
    int    few_iterations     = 0;     ///< beside these, of few bodies that settle alone
    int    solver_iterations  = 0;     ///< of the linear solver, summed
    int    factorizations     = 0;
    double first_residual     = 0.; ///< relative force residual where the trial begins [-]
    double residual           = 0.; ///< at the end [-]
    double displacement_ratio = 0.; ///< largest displacement over block size [-]
    double unbalanced =
      0.; ///< relative inertial force at the end (the static residual of a step from rest), or a
          ///< thousandth of a single block's beside its own forces [-]
    int  largest_block = -1;    ///< block that moved most, relative to its size
    bool is_passed     = false; ///< a vertex would go into a body before it could have a contact
  };
} // namespace hybrid::dda
