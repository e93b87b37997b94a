// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block.h>
#include <hybrid/scene/maxwell_body.h>

#include <algorithm>
#include <vector>

namespace hybrid::dda
{
  /**
   * Maxwell damping of blocks: branches beside the elasticity D of each block, all with the same
   * isotropic matrix V times their weights,
   *
   *     s = D e + V [(relaxed - 1) e + sum_l weight_l s_l],   s_l' = e' - s_l / t_l.
   *
   * Joints stay elastic. In series with them a block has to lose more for the jointed mass to have
   * the ratio. With D_m the material's elasticity, which is that of blocks and joints together, V
   * beside D changes D_m by D_m (1/D) V (1/D) D_m. So V = D (1/D_m) D damps the mass as V = D_m
   * damps the material, but for terms of second order in 1/Q.
   */
  struct MaxwellBlocks
  {
    MaxwellBody mass, bedrock;

    /// V of each block [Pa]; zero where the body is elastic. Empty: no block is damped.
    std::vector<Eigen::Matrix3d> stiffness;

    bool is_on() const
    {
      return !stiffness.empty();
    }

    /// Places in DdaState::branch_stress for each block.
    std::size_t n_branches() const
    {
      return std::max(mass.n_branches(), bedrock.n_branches());
    }
  };


  /// V of MaxwellBlocks. @param corrected D, of the block @param material D_m
  /// @throws InputError if the block had no stiffness in the long term.
  Eigen::Matrix3d branch_stiffness(const Eigen::Matrix3d &corrected,
                                   const Eigen::Matrix3d &material,
                                   const MaxwellBody     &body);
} // namespace hybrid::dda
