// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/rest_forces.h>
#include <hybrid/dda/step/start_accelerations.h>

#include <Eigen/Cholesky>

namespace hybrid::dda
{
  void start_accelerations(const Model &model, DdaState &state)
  {
    const RestForces springs(model, state);
    const Water      water = model.water.at(state.time);
    for (int b = 0; b < model.n_blocks(); ++b)
      {
        const BlockProperties &p     = model.blocks[b];
        BlockState            &block = state.blocks[b];
        Vec6                   force = springs.bonds.segment<6>(6 * b);
        force[0] += p.pushed_mass * model.horizontal;
        force[1] -= p.weight * model.gravity;
        force.tail<3>() -= p.area * block.stress;
        if (!model.dead_loads.empty() && !model.is_bedrock(b))
          force += model.dead_loads[b];
        if (model.is_bedrock(b) && state.bedrock_static_force.size() > 0)
          force -= state.bedrock_static_force.segment<6>(6 * model.bedrock_number(b));
        if (water.action != Water::Action::none && !model.is_bedrock(b))
          {
            const Geometry &g     = state.geometry;
            const int       first = g.offset[b];
            force += water_load(water,
                                p.area,
                                BlockMotion(block.centroid, Vec6::Zero()),
                                {&g.vertices[first], nullptr, g.offset[b + 1] - first})
                       .force;
          }
        const Vec6             contact = springs.contacts.segment<6>(6 * b);
        const Eigen::LLT<Mat6> mass(mass_matrix(p, block.rotation));
        block.acceleration         = mass.solve(force + contact);
        block.contact_acceleration = mass.solve(contact);
      }
  }
} // namespace hybrid::dda
