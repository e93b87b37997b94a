// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// @file
/// Small parts of OpenCloseIteration.
namespace hybrid::dda
{
  /// What steps remember of how the one before was solved, for the checkpoint.
  struct ActiveSetMemory
  {
    int path_steps = 0; ///< steps that begin with the interior point method at once
    int path_span  = 0; ///< of them when it was last decided
  };


  /// What an attempt to solve the step came to.
  enum class Attempt
  {
    converged,
    failed,
    stuck, ///< few bodies find no conditions: nothing else is tried
    stopped
  };


  /// How far contacts go along a direction of the interior point method.
  enum class Stride
  {
    own,   ///< bodies all of it, each contact as far as it can
    common ///< all as far as all can
  };


  /// How wide the central path is, and whether it advances: not where, twice in a row, next to
  /// nothing can be taken of a direction, the products do not fall, and the residual stays near the
  /// least that there was. (Where contacts are stuck at their bounds the bodies may go to and fro
  /// between two places.)
  class PathProgress
  {
  public:
    double width = 1.; ///< beside that of a path of usual width

    /// @param part of the last direction that all contacts could take; the residual and the mean
    /// product after it
    void saw(const double part, const double residual, const double product)
    {
      constexpr double least_part = 0.01, least_gain = 0.7, falls = 0.9;
      const bool       stays =
        part < least_part && residual > least_gain * least && product > falls * last;
      held  = stays ? held + 1 : 0;
      least = std::min(least, residual);
      last  = product;
    }

    bool holds() const
    {
      return held >= 2;
    }

  private:
    double least = std::numeric_limits<double>::infinity(); ///< residual so far
    double last  = std::numeric_limits<double>::infinity(); ///< mean product
    int    held  = 0;                                       ///< iterations in a row
  };


  /// Whether updates go round in circles of two or three: a residual comes back.
  class Circles
  {
  public:
    /// @param before, after: residuals of one update
    bool close(const double before, const double after)
    {
      constexpr double same      = 1e-6;
      last[next++ % last.size()] = before;
      return std::any_of(last.begin(), last.end(), [&](const double r) {
        return r > 0. && r != before && std::abs(after - r) <= same * r;
      });
    }

  private:
    std::array<double, 3> last{-1., -1., -1.};
    std::size_t           next = 0;
  };


  /// How long updates with frozen conditions go on.
  struct Patience
  {
    int updates;   ///< at most
    int slow_ones; ///< that do not halve the residual, at most
  };


  /**
   * Bonds that seem to crack hold at first, until contacts have settled: where a step begins blocks
   * that turn part along the tangents of their ways, and before contacts have their conditions
   * blocks move as nothing does. Blocks whose bonds crack by that may be left in a balance, parted.
   */
  struct WholeBonds
  {
    bool   may_be;           ///< until contacts have settled
    bool   are_held = false; ///< any, in the last trial
    double largest  = 0.;    ///< residual with bonds that are held [-]
    int    updates  = 0;     ///< with them
  };


  /// Where a line search ended.
  struct LineSearch
  {
    double residual; ///< relative norm there
    double fraction; ///< of the update that was taken
  };
} // namespace hybrid::dda
