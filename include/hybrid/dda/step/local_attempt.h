// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/contact_state.h>
#include <hybrid/dda/linear/local_system.h>
#include <hybrid/dda/step/step_problem.h>

#include <limits>
#include <vector>

namespace hybrid::dda
{
  /// Where the open-close iteration is while only few bodies move.
  struct LocalAttempt
  {
    /// Part of a residual that the linear solver may leave: the others are held anyway.
    static constexpr double accuracy = 3e-3;

    LocalSystem system;
    bool        is_stuck = false; ///< the last one of this step found no conditions
    double      stuck_at = -std::numeric_limits<double>::infinity(); ///< time from which a step was
                                                                     ///< given up for that [s]
    double tolerance = 0.; ///< of the bodies' own relative residual
    double enough = std::numeric_limits<double>::infinity(); ///< what the linear solver may leave
                                                             ///< of it, at most
    TrialPlace             start;
    std::vector<Condition> conditions; ///< of springs at the start; in the end those to go on with
  };
} // namespace hybrid::dda
