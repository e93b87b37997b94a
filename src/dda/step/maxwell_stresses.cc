// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/maxwell_stresses.h>

namespace hybrid::dda
{
  namespace
  {
    const MaxwellBody &body_of(const Model &model, const int block)
    {
      return model.is_bedrock(block) ? model.maxwell.bedrock : model.maxwell.mass;
    }



    /// Where the branches of a block begin in DdaState::branch_stress.
    std::size_t first_branch(const Model &model, const int block)
    {
      return model.maxwell.n_branches() * static_cast<std::size_t>(block);
    }



    /// Energy of the spring of a branch [J/m2].
    double branch_energy(const Model           &model,
                         const int              block,
                         const std::size_t      l,
                         const Eigen::Vector3d &stress)
    {
      const double weight = body_of(model, block).weight[l];
      return weight > 0. ? strain_energy_density(weight * model.maxwell.stiffness[block], stress)
                         : 0.;
    }



    /// Energy of the spring beside the branches, which bears @p stress [J/m2].
    double relaxed_energy(const Model &model, const int block, const Eigen::Vector3d &stress)
    {
      return strain_energy_density(model.blocks[block].elasticity +
                                     (body_of(model, block).relaxed - 1.) *
                                       model.maxwell.stiffness[block],
                                   stress);
    }
  } // namespace



  void MaxwellStresses::begin(const Model &model, const DdaState &state, const double step_size)
  {
    dt                  = step_size;
    const std::size_t n = model.maxwell.is_on() ? model.blocks.size() : 0;
    past_stress.resize(n);
    added_stiffness.resize(n);
    for (std::size_t b = 0; b < n; ++b)
      {
        const MaxwellBody &body = body_of(model, static_cast<int>(b));
        const auto *t = state.branch_stress.data() + first_branch(model, static_cast<int>(b));
        past_stress[b].setZero();
        for (std::size_t l = 0; l < body.n_branches(); ++l)
          past_stress[b] += (body.kept(dt, l) - 1.) * t[l];
        added_stiffness[b] = body.step_modulus(dt) * model.maxwell.stiffness[b];
      }
  }



  Eigen::Vector3d MaxwellStresses::after(const Model           &model,
                                         const DdaState        &before,
                                         const Eigen::Vector3d &strain,
                                         const int              block,
                                         const std::size_t      l) const
  {
    const MaxwellBody &body = body_of(model, block);
    return body.kept(dt, l) * before.branch_stress[first_branch(model, block) + l] +
           body.gained(dt, l) * body.weight[l] * (model.maxwell.stiffness[block] * strain);
  }



  double MaxwellStresses::loss(const Model           &model,
                               const DdaState        &before,
                               const Eigen::Vector3d &strain,
                               const int              block) const
  {
    const MaxwellBody &body = body_of(model, block);
    double             sum  = 0.;
    for (std::size_t l = 0; l < body.n_branches(); ++l)
      {
        const Eigen::Vector3d mean = 0.5 * (before.branch_stress[first_branch(model, block) + l] +
                                            after(model, before, strain, block, l));
        sum += 2. * dt / body.time[l] * branch_energy(model, block, l, mean);
      }
    return sum;
  }



  double MaxwellStresses::stored(const Model           &model,
                                 const DdaState        &before,
                                 const Eigen::Vector3d &stress,
                                 const Eigen::Vector3d &strain,
                                 const int              block) const
  {
    Eigen::Vector3d rest = stress;
    double          sum  = 0.;
    for (std::size_t l = 0; l < body_of(model, block).n_branches(); ++l)
      {
        const Eigen::Vector3d t = after(model, before, strain, block, l);
        rest -= t;
        sum += branch_energy(model, block, l, t);
      }
    return sum + relaxed_energy(model, block, rest);
  }



  void MaxwellStresses::advance(const Model           &model,
                                const BlockMotion     &move,
                                const Eigen::Vector3d &strain,
                                const int              block,
                                DdaState              &state) const
  {
    const std::size_t first = first_branch(model, block);
    for (std::size_t l = 0; l < body_of(model, block).n_branches(); ++l)
      state.branch_stress[first + l] =
        rotated_stress(after(model, state, strain, block, l), move.cosine, move.sine);
  }



  double maxwell_energy(const Model &model, const DdaState &state, const int block)
  {
    Eigen::Vector3d rest = state.blocks[block].stress;
    double          sum  = 0.;
    for (std::size_t l = 0; l < body_of(model, block).n_branches(); ++l)
      {
        const Eigen::Vector3d &t = state.branch_stress[first_branch(model, block) + l];
        rest -= t;
        sum += branch_energy(model, block, l, t);
      }
    return sum + relaxed_energy(model, block, rest);
  }
} // namespace hybrid::dda
