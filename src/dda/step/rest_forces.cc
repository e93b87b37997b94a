// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/rest_forces.h>

namespace hybrid::dda
{
  Trial trial_at_rest(const DdaState &state)
  {
    Trial trial;
    trial.dt = 1.;
    trial.displacement.assign(state.geometry.vertices.size(), Vec2::Zero());
    trial.foundation = state.foundation_displacement;
    for (const BlockState &block : state.blocks)
      trial.motion.emplace_back(block.centroid, Vec6::Zero());
    return trial;
  }



  Springs springs_at_rest(const Model &model, const DdaState &state)
  {
    Springs springs;
    springs.collect(model, state);
    springs.evaluate(model, state, trial_at_rest(state));
    return springs;
  }



  RestForces::RestForces(const Model &model, const DdaState &state)
    : bonds(Eigen::VectorXd::Zero(6 * model.n_blocks() + 2 * model.n_foundation_nodes()))
    , contacts(bonds)
  {
    const Springs   springs  = springs_at_rest(model, state);
    Eigen::VectorXd absolute = Eigen::VectorXd::Zero(model.n_blocks());
    springs.add_forces(bonds, contacts, absolute);
  }
} // namespace hybrid::dda
