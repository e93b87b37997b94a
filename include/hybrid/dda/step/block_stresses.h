// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/step/maxwell_stresses.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Stresses of the blocks in a trial, and what of its strain is plastic.
   *
   * The slider of a block that yields is in series with its spring and its damper, as that of a
   * joint: the return is that of the stress with the damping's part, with the stiffness
   * (1 + beta_K / dt) D, and with that of Maxwell branches. Blocks that do not yield cost nothing
   * but the sum.
   */
  class BlockStresses
  {
  public:
    /// Begin a step of @p dt [s] from @p state.
    void begin(const Model &model, const DdaState &state, double dt);

    /// Stress of a block, the damping's part included [Pa].
    /// @param strain of the step @param viscous beta_K / dt [-]
    Eigen::Vector3d evaluate(const BlockProperties &properties,
                             const BlockState      &before,
                             const Eigen::Vector3d &strain,
                             double                 viscous,
                             int                    block)
    {
      const Eigen::Vector3d scaled = (1. + viscous) * strain;
      Eigen::Vector3d       trial  = before.stress + properties.elasticity * scaled;
      if (maxwell.is_on())
        trial += maxwell.past(block) + maxwell.added(block) * strain;
      return plastic.empty() ? trial : yielded(properties, trial, viscous, block);
    }

    /// Stiffness of a block in the trial, the damping's part included [Pa].
    Eigen::Matrix3d tangent(const BlockProperties &properties, double viscous, int block) const
    {
      if (!plastic.empty() && plastic[block].region != YieldRegion::elastic)
        return plastic[block].tangent;
      return stiffness(properties, viscous, block);
    }

    /// Of the stress over the step, without the damping's part [Pa]. @param elastic D times
    /// @p strain, the strain that springs back
    Eigen::Vector3d
    change(const Eigen::Vector3d &elastic, const Eigen::Vector3d &strain, const int block) const
    {
      if (!maxwell.is_on())
        return elastic;
      return elastic + maxwell.past(block) + maxwell.added(block) * strain;
    }

    const MaxwellStresses &branches() const
    {
      return maxwell;
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
    MaxwellStresses            maxwell;

    /// Stiffness of a block that does not yield [Pa].
    Eigen::Matrix3d stiffness(const BlockProperties &properties, double viscous, int block) const
    {
      if (maxwell.is_on())
        return (1. + viscous) * properties.elasticity + maxwell.added(block);
      return (1. + viscous) * properties.elasticity;
    }

    Eigen::Vector3d yielded(const BlockProperties &properties,
                            const Eigen::Vector3d &trial,
                            double                 viscous,
                            int                    block);
  };
} // namespace hybrid::dda
