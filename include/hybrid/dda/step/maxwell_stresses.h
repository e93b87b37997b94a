// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block_motion.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Stresses of Maxwell branches in a trial (MaxwellBlocks). With t_l = weight_l V s_l a step of
   * the strain e changes the stress of a block by
   *
   *     D e + past + added e,   past = sum_l (kept_l - 1) t_l0,   added = step_modulus V
   *
   * and t_l1 = kept_l t_l0 + gained_l weight_l V e: linear in e, with a constant tangent.
   */
  class MaxwellStresses
  {
  public:
    /// Begin a step of @p step_size [s] from @p state.
    void begin(const Model &model, const DdaState &state, double step_size);

    bool is_on() const
    {
      return !past_stress.empty();
    }

    /// What relaxes in the step if a block keeps its strain [Pa].
    const Eigen::Vector3d &past(const int block) const
    {
      return past_stress[block];
    }

    /// Stiffness beside D in the step [Pa].
    const Eigen::Matrix3d &added(const int block) const
    {
      return added_stiffness[block];
    }

    /// What the dashpots of a block take in a step of the elastic strain @p strain, per area
    /// [J/m2]; never negative.
    double loss(const Model           &model,
                const DdaState        &before,
                const Eigen::Vector3d &strain,
                int                    block) const;

    /// Energy that a block holds after such a step, per area [J/m2]. @param stress its stress then
    double stored(const Model           &model,
                  const DdaState        &before,
                  const Eigen::Vector3d &stress,
                  const Eigen::Vector3d &strain,
                  int                    block) const;

    /// Branch stresses of a block in @p state after such a step, turned with it.
    void advance(const Model           &model,
                 const BlockMotion     &move,
                 const Eigen::Vector3d &strain,
                 int                    block,
                 DdaState              &state) const;

  private:
    double                       dt = 0.; ///< [s]
    std::vector<Eigen::Vector3d> past_stress;
    std::vector<Eigen::Matrix3d> added_stiffness;

    /// t_l1 before the block turns [Pa].
    Eigen::Vector3d after(const Model           &model,
                          const DdaState        &before,
                          const Eigen::Vector3d &strain,
                          int                    block,
                          std::size_t            branch) const;
  };


  /// Energy of a block with the stress and the branches of @p state, per area [J/m2].
  double maxwell_energy(const Model &model, const DdaState &state, int block);
} // namespace hybrid::dda
