// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/start_accelerations.h>
#include <hybrid/dda/static_steps.h>

#include <Eigen/Cholesky>

namespace hybrid::dda
{
  namespace
  {
    /// What springs do to blocks and base nodes in a state, bonds and contacts apart.
    struct SpringForces
    {
      Eigen::VectorXd bonds, contacts;

      SpringForces(const Model &model, const DdaState &state)
        : bonds(Eigen::VectorXd::Zero(6 * model.n_blocks() + 2 * model.n_base_nodes()))
        , contacts(bonds)
      {
        const Springs   springs  = springs_at_rest(model, state);
        Eigen::VectorXd absolute = Eigen::VectorXd::Zero(model.n_blocks());
        springs.add_forces(bonds, contacts, absolute);
      }
    };
  } // namespace



  Springs springs_at_rest(const Model &model, const DdaState &state)
  {
    Trial trial; // nothing moves
    trial.dt = 1.;
    trial.displacement.assign(state.geometry.vertices.size(), Vec2::Zero());
    trial.base = state.base_displacement;
    for (const BlockState &block : state.blocks)
      trial.motion.emplace_back(block.centroid, Vec6::Zero());
    Springs springs;
    springs.collect(model, state);
    springs.evaluate(model, state, trial);
    return springs;
  }



  void start_accelerations(const Model &model, DdaState &state)
  {
    const SpringForces springs(model, state);
    for (int b = 0; b < model.n_blocks(); ++b)
      {
        const BlockProperties &p     = model.blocks[b];
        BlockState            &block = state.blocks[b];
        Vec6                   force = springs.bonds.segment<6>(6 * b);
        force[1] -= p.weight * model.gravity;
        force.tail<3>() -= p.area * block.stress;
        if (model.is_bedrock(b) && state.bedrock_static_force.size() > 0)
          force -= state.bedrock_static_force.segment<6>(6 * model.bedrock_number(b));
        if (model.water.action != Water::Action::none && !model.is_bedrock(b))
          {
            const Geometry &g     = state.geometry;
            const int       first = g.offset[b];
            force += water_load(model.water,
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



  void begin_motion(const Model &model, DdaState &state, const bool held)
  {
    if (model.n_bedrock > 0)
      {
        const SpringForces springs(held ? with_unlimited_strengths(model) : model, state);
        const int          first = 6 * model.n_mass(), n = 6 * model.n_bedrock;
        state.bedrock_static_force =
          springs.bonds.segment(first, n) + springs.contacts.segment(first, n);
      }
    start_accelerations(held ? with_unlimited_bonds(model) : model, state);
  }



  void bear_rest(const Model &model, DdaState &state, const bool held)
  {
    const SpringForces springs(held ? with_unlimited_strengths(model) : model, state);
    const int          first = 6 * model.n_blocks(), n = 2 * model.n_base_nodes();
    state.base_contact_force   = springs.contacts.segment(first, n);
    state.base_force           = springs.bonds.segment(first, n) + state.base_contact_force;
    state.static_force         = state.base_force;
    state.static_contact_force = state.base_contact_force;
    begin_motion(model, state, held);
  }
} // namespace hybrid::dda
