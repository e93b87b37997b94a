// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Stresses of the blocks in a trial, and what of its strain is plastic.
   *
   * The slider of a block that yields is in series with its spring and its damper, as that of a
   * joint: the return is that of the stress with the damping's part, with the stiffness
   * (1 + beta_K / dt) D. Blocks that do not yield cost nothing but the sum.
   */
  class BlockStresses
  {
  public:
    /// Make room for a step of @p model.
    void begin(const Model &model);

    /// Stress of a block, the damping's part included [Pa].
    /// @param strain of the step @param viscous beta_K / dt [-]
    Eigen::Vector3d evaluate(const BlockProperties &properties,
                             const BlockState      &before,
                             const Eigen::Vector3d &strain,
                             double                 viscous,
                             int                    block)
    {
      const Eigen::Vector3d scaled = (1. + viscous) * strain;
      const Eigen::Vector3d trial  = before.stress + properties.elasticity * scaled;
      return plastic.empty() ? trial : yielded(properties, trial, viscous, block);
    }

    /// Stiffness of a block in the trial, the damping's part included [Pa].
    Eigen::Matrix3d tangent(const BlockProperties &properties, double viscous, int block) const
    {
      if (!plastic.empty() && plastic[block].region != YieldRegion::elastic)
        return plastic[block].tangent;
      return (1. + viscous) * properties.elasticity;
    }

    /// The strain of the step that springs back [-].
    Eigen::Vector3d elastic_strain(const Eigen::Vector3d &strain, const int block) const
    {
      return plastic.empty() ? strain : Eigen::Vector3d(strain - plastic[block].plastic_strain);
    }

    /// Added by the step: (ex, ey, gxy) [-].
    Eigen::Vector3d plastic_strain(const int block) const
    {
      return plastic.empty() ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                             : plastic[block].plastic_strain;
    }

    /// True if no block has a tangent that is not symmetric.
    bool is_symmetric() const;

  private:
    std::vector<YieldResponse> plastic; ///< of each block; empty: none yields

    Eigen::Vector3d yielded(const BlockProperties &properties,
                            const Eigen::Vector3d &trial,
                            double                 viscous,
                            int                    block);
  };
} // namespace hybrid::dda
