// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

namespace hybrid::dda
{
  /**
   * How far the linear system of each update in a step is solved: to a tenth of what the update of
   * the same number has left in the step before.
   *
   * An update with frozen conditions leaves what the conditions that change with it are worth; what
   * the linear solver does beyond that is lost. Steps are alike, so the last one tells. Where fewer
   * conditions change than in the last step, the linear solver's tenth is what is left, and the
   * next step is solved as much further. (Inexact Newton: Eisenstat and Walker 1996, whose choices
   * look back within one iteration.)
   */
  struct UpdateAccuracy
  {
    static constexpr int    longest = 16;   ///< updates that are remembered
    static constexpr double finest  = 1e-6; ///< part of the residual, also where nothing is known
    /// Well below the 1e-3 that a kept tangent may leave, or it would be blamed for it.
    static constexpr double coarsest = 3e-4;

    /// Part of a residual that the update of this number left in the last step.
    std::array<double, longest> left{};

    /// Part of the residual that the linear solver may leave. @param update its number, from 0
    double part(const int update) const
    {
      return update < longest ? std::clamp(0.1 * left[update], finest, coarsest) : finest;
    }

    /// @param part_left by an update of this number; 0 if it settled the step
    void saw(const int update, const double part_left)
    {
      if (update < longest)
        left[update] = part_left;
    }
  };
} // namespace hybrid::dda
