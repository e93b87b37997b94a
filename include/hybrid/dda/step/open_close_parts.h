// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block_motion.h>

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <vector>

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


  struct DdaState;
  struct FoundationResponse;
  struct Model;
  struct StepResult;


  /// What the iteration works on.
  struct StepUnderWay
  {
    const Model              &model;
    const DdaState           &state;
    const FoundationResponse &foundation;
    StepResult               &result;
  };


  /// What a tangent is made of.
  struct Tangent
  {
    bool follow_softening; ///< of joints, see SpringStiffness
    bool all;              ///< rows, not only those of springs that have changed
  };


  /// How wide the central path is, and whether it advances: not where next to nothing can be taken
  /// of two directions in a row, and neither brings the residual well below the least that there
  /// was. (Where contacts are stuck at their bounds the bodies may go to and fro between two
  /// places.)
  class PathProgress
  {
  public:
    double width = 1.; ///< beside that of a path of usual width

    /// @param part of the last direction that all contacts could take; the residual after it
    void saw(const double part, const double residual)
    {
      constexpr double least_part = 0.01, least_gain = 0.7;
      held  = part < least_part && residual > least_gain * least ? held + 1 : 0;
      least = std::min(least, residual);
    }

    bool holds() const
    {
      return held >= 2;
    }

  private:
    double least = std::numeric_limits<double>::infinity(); ///< residual so far
    int    held  = 0;                                       ///< iterations in a row
  };


  /// How long updates with frozen conditions go on.
  struct Patience
  {
    int updates;   ///< at most
    int slow_ones; ///< that do not halve the residual, at most
  };


  /// Where a line search ended.
  struct LineSearch
  {
    double residual; ///< relative norm there
    double fraction; ///< of the update that was taken
  };


  /// Where a trial was.
  struct TrialPlace
  {
    std::vector<Vec6> increment;  ///< of each block
    Eigen::VectorXd   foundation; ///< displacement of the foundation nodes [m]
  };
} // namespace hybrid::dda
