// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model.h>
#include <hybrid/dda/state.h>

#include <functional>

namespace hybrid::dda
{
  /// What became of the static stage.
  struct StaticResult
  {
    bool   equilibrium          = false; ///< relative residual below the target
    bool   stopped              = false; ///< by whoever watches: the state is of no use
    int    steps                = 0;
    int    iterations           = 0; ///< open-close iterations
    int    cuts                 = 0;
    double residual             = 0.; ///< relative to the sum of absolute forces [-]
    double largest_displacement = 0.; ///< of a centroid [m]
    int    moving_block = -1; ///< that moved most in the last step, if there is no equilibrium
  };


  /// How far the static stage is.
  struct StaticProgress
  {
    int    steps      = 0;  ///< done
    int    iterations = 0;  ///< open-close iterations done
    double residual   = 1.; ///< after the last step [-]
    double target     = 0.; ///< the stage ends at this residual [-]
  };

  /// Told before every open-close iteration; the stage ends where it returns false.
  using StaticWatch = std::function<bool(const StaticProgress &)>;


  /**
   * Let the blocks settle under gravity on the fixed base, strengths active.
   *
   * Implicit steps from rest, without damping, with a pseudo time step that
   * grows until inertia is negligible: Newton's method for the static problem
   * with mass as regularisation, so that a mass that cannot stand is seen to
   * move instead of giving a singular matrix. Ends at rest with a relative
   * residual of 1e-9; joints that failed carry a negative failure time. The
   * forces on the base become DdaState::static_force.
   */
  /// @param held friction and bonds are unlimited while the blocks settle.
  /// @param watch may be empty.
  StaticResult
  settle(const Model &model, DdaState &state, bool held = false, const StaticWatch &watch = {});
} // namespace hybrid::dda
