// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace hybrid
{
  class Processes;

  /// From a time on, steps that are Time/Time step divided by 2^halvings.
  struct StepLevel
  {
    double from; ///< [s]
    int    halvings;
  };

  /**
   * How a run had its steps cut, in the order of time, from whole steps at t = 0.
   *
   * The difference of two runs tells the error of what both took different steps through. Where one
   * was cut to the steps of the other, they are the same run, and the difference is nothing at all,
   * however large the error is there. A further run whose steps are cut as those of the first were
   * has the same ratio of steps everywhere, as Richardson's extrapolation asks for.
   *
   * @param ends of steps [s]
   */
  std::vector<StepLevel> step_plan(const std::vector<double> &ends, double time_step);

  /// That of the first process, on all.
  std::vector<StepLevel> from_first(std::vector<StepLevel> plan, const Processes &processes);
} // namespace hybrid
