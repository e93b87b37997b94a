// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs/springs.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /**
   * What acts on the blocks of the bedrock besides springs, stress and inertia:
   * the artificial boundaries (ViscousBoundary), and the forces that the bedrock
   * bore when the static stage ended. The section as drawn is the deformed state in
   * place, so these are balanced by stresses that are not followed: blocks of
   * the bedrock have no weight, are held while the mass settles, and feel only
   * changes afterwards.
   */
  struct BedrockStep
  {
    const Model           &model;
    const DdaState        &before;   ///< state when the step began
    const Trial           &trial;    ///< with the rates of blocks on boundaries
    const Eigen::VectorXd &incoming; ///< at the end of the step [N/m]; empty: no dashpots act
  };

  /// Add the forces on these @p blocks, ascending, to @p residual, their sizes to @p absolute; a
  /// held bedrock has no residual.
  void add_bedrock_forces(const BedrockStep      &step,
                          const std::vector<int> &blocks,
                          Eigen::VectorXd        &residual,
                          Eigen::VectorXd        &absolute);

  /// Add the dashpots' tangent to the rows of these @p blocks, ascending; a held bedrock is cut off
  /// from the blocks on it.
  void add_bedrock_stiffness(const BedrockStep      &step,
                             const std::vector<int> &blocks,
                             BlockMatrix            &matrix);

  /// Energy of boundaries and static forces in an accepted step.
  void audit_bedrock(const BedrockStep &step, BlockEnergy &energy);
} // namespace hybrid::dda
