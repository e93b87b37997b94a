// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/springs.h>
#include <hybrid/dda/start_accelerations.h>

#include <Eigen/Cholesky>

namespace hybrid::dda
{
  void start_accelerations(const Model &model, DdaState &state)
  {
    const int n = model.n_blocks(), m = model.n_base_nodes();
    Trial     trial; // nothing moves
    trial.dt = 1.;
    trial.displacement.assign(state.geometry.vertices.size(), Vec2::Zero());
    trial.base = state.base_displacement;
    for (const BlockState &block : state.blocks)
      trial.motion.emplace_back(block.centroid, Vec6::Zero());

    Springs springs;
    springs.collect(model, state);
    springs.evaluate(model, state, trial);
    Eigen::VectorXd forces   = Eigen::VectorXd::Zero(6 * n + 2 * m);
    Eigen::VectorXd contacts = forces, absolute = Eigen::VectorXd::Zero(n);
    springs.add_forces(trial, forces, contacts, absolute);

    for (int b = 0; b < n; ++b)
      {
        const BlockProperties &p     = model.blocks[b];
        BlockState            &block = state.blocks[b];
        Vec6                   force = forces.segment<6>(6 * b);
        force[1] -= p.weight * model.gravity;
        force.tail<3>() -= p.area * block.stress;
        if (model.water.action != Water::Action::none)
          {
            const Geometry &g     = state.geometry;
            const int       first = g.offset[b];
            force += water_load(model.water,
                                p.area,
                                trial.motion[b],
                                {&g.vertices[first], nullptr, g.offset[b + 1] - first})
                       .force;
          }
        const Vec6             contact = contacts.segment<6>(6 * b);
        const Eigen::LLT<Mat6> mass(mass_matrix(p, block.rotation));
        block.acceleration         = mass.solve(force + contact);
        block.contact_acceleration = mass.solve(contact);
      }
  }
} // namespace hybrid::dda
