// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/node_matrices.h>

#include <vector>

namespace hybrid::continuum
{
  /// Diagonal of a supported unknown of the surface over that of the matrix.
  constexpr double support_ratio = 1e6;

  /**
   * Lower triangle by columns of the matrix that is factored, and where in the
   * 2 x 2 blocks of a node matrix each entry comes from.
   */
  struct SystemPattern
  {
    std::vector<int> column_start, row;
    std::vector<int> source; ///< per entry: index into blocks; -1 - index: a stiff support instead

    /// Entries of the lower triangle from 2 x 2 blocks on the pattern of the node matrices.
    std::vector<double> values(const std::vector<double> &blocks) const;
  };


  /// @param system_of_dof number in the system per unknown, -1: left out.
  /// @param dof_of_system the inverse.
  /// @param isolated per unknown: supported, but kept in the system without its neighbours.
  SystemPattern make_system_pattern(const NodeMatrices      &matrices,
                                    const std::vector<int>  &system_of_dof,
                                    const std::vector<int>  &dof_of_system,
                                    const std::vector<char> &isolated);
} // namespace hybrid::continuum
