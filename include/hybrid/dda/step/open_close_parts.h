// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block_motion.h>

#include <Eigen/Core>

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
