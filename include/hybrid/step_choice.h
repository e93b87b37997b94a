// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/summary.h>

#include <optional>

namespace hybrid
{
  /// What `Time/Error target` calls for after a run.
  struct StepChoice
  {
    /// Why the run stands although the target is not known to be met; empty: it is met, or step is
    /// given.
    std::string unmet;

    /// Step to run the scene with again: the one there was over a power of two [s].
    std::optional<double> step;

    std::string why; ///< to run it again
  };


  /// The largest step whose probable error of displacements and velocities is at most @p target
  /// [-]. That of half the step is estimated; further halvings gain what the first one has gained,
  /// but no more than a factor of four (second order). At most four halvings at a time. Where the
  /// difference of two runs tells the error, or would, half the step.
  StepChoice
  choose_step(const output::Summary::ProbableError &error, double time_step, double target);
} // namespace hybrid
