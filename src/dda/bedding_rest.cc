// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/bedding_rest.h>
#include <hybrid/dda/block_energy.h>
#include <hybrid/dda/model_builder.h>
#include <hybrid/dda/open_close_iteration.h>
#include <hybrid/dda/start_accelerations.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    using scene::BeddingParameters;

    constexpr double load_part       = 1e-3; ///< of loads and strengths in the model at rest
    constexpr double target_residual = 1e-9;
    constexpr double first_step      = 0.0156; ///< pseudo time step [s]
    constexpr double smallest_step   = 1e-5;
    constexpr double largest_step    = 1e3;
    constexpr double growth          = 4.;
    constexpr int    maximum_steps   = 200;



    /// A part of loads and strengths.
    BeddingParameters scaled(BeddingParameters bedding)
    {
      bedding.cohesion *= load_part;
      bedding.tensile_strength *= load_part;
      bedding.initial_normal_stress *= load_part;
      return bedding;
    }



    /// Fixes an edge of a block at the base, lets it slide along a side.
    Joint support(const Model &model, const BoundaryEdge &edge, const int first_node)
    {
      const double k = model.block_contact[edge.block].law.normal_stiffness();
      return {edge.block,
              edge.vertex,
              base_body,
              (edge.ends[1] - edge.ends[0]).norm(),
              {{0., first_node}, {1., first_node + 1}},
              JointLaw(edge.part == BoundaryPart::base ? JointStrength::unlimited_bond()
                                                       : JointStrength::roller(),
                       k,
                       k),
              1.,
              JointKind::weld};
    }



    /// The bedrock alone on its supports. Blocks of the mass stay without load and joints.
    Model rest_model(const Model &model, const BeddingParameters &bedding)
    {
      Model copy                = model;
      copy.bedrock_damping_time = copy.joint_damping_time = 0.;
      copy.dynamic_coefficient                            = 1.;
      copy.newmark                                        = Newmark::preset("shi");
      copy.iteration.tolerance                            = 0.1 * target_residual;
      copy.water                                          = {};
      copy.edge_loads.edges.clear();
      copy.joints.clear();
      copy.boundary.clear();
      for (BlockProperties &block : copy.blocks)
        block.damping_time = block.weight = 0.;
      const BeddingParameters part = scaled(bedding);
      for (Joint joint : model.joints)
        if (joint.within_bedrock())
          {
            if (joint.kind == JointKind::bedding)
              joint.law = joint.law.with(JointStrength::bedding_plane(part));
            copy.joints.push_back(joint);
          }
      for (const BoundaryEdge &edge : model.boundary)
        {
          copy.joints.push_back(support(model, edge, copy.n_base_nodes()));
          copy.initial.base_nodes.insert(copy.initial.base_nodes.end(),
                                         {edge.ends[0], edge.ends[1]});
        }
      return copy;
    }



    /// Give an end of a joint the elastic stretch of these tractions [Pa].
    void stretch(const Model &model, const Joint &joint, const Vec2 &traction, SpringState &point)
    {
      const Geometry &g  = model.initial;
      const Vec2 tangent = (g.vertices[g.next(joint.edge)] - g.vertices[joint.edge]).normalized();
      const Vec2 normal(tangent.y(), -tangent.x());
      point.gap    = -traction[0] / joint.law.normal_stiffness();
      point.slip   = -traction[1] / joint.law.shear_stiffness();
      point.jump   = point.gap * normal + point.slip * tangent;
      point.normal = point.elastic_normal = traction[0];
      point.shear = point.elastic_shear = traction[1];
    }



    /// Weight and the mass's forces beside what balances the uniform compression.
    void load(const Model &model, const DdaState &state, DdaState &rest)
    {
      for (int k = 0; k < model.n_bedrock; ++k)
        {
          const double weight = model.blocks[model.n_mass() + k].weight_at_rest * model.gravity;
          rest.bedrock_static_force[6 * k + 1] += load_part * weight;
        }
      if (state.bedrock_static_force.size() > 0)
        rest.bedrock_static_force -= load_part * state.bedrock_static_force;
    }



    /// Implicit steps from rest, as those of the mass's static stage. @return true at rest.
    bool settle(const Model &model, DdaState &rest)
    {
      OpenCloseIteration iteration;
      BaseResponse       base;
      base.displacement = rest.base_displacement;
      int steps         = 0;
      for (double dt = first_step; steps < maximum_steps && dt >= smallest_step;)
        {
          for (BlockState &block : rest.blocks)
            {
              block.velocity.setZero();
              block.acceleration.setZero();
              block.contact_acceleration.setZero();
            }
          const StepResult step = iteration.solve(model, rest, base, dt);
          if (!step.converged)
            {
              dt /= 4.;
              continue;
            }
          iteration.accept(model, rest);
          ++steps;
          if (step.unbalanced <= target_residual)
            return true;
          dt = std::min(largest_step, growth * dt);
        }
      return false;
    }



    /// Tractions of the model at rest onto an end of a joint.
    void take(const Model       &model,
              const Joint       &joint,
              const int          end,
              const SpringState &found,
              BeddingRest       &result,
              SpringState       &point)
    {
      const double slip = std::abs(found.history.plastic_slip) / load_part;
      point.history     = {};
      if (found.history.damage >= 1.)
        point.history.damage = 1.;
      point.state = found.state;
      result.slipping += found.state == ContactState::sliding;
      result.open += found.state == ContactState::open;
      if (found.state != ContactState::open && slip > result.largest)
        {
          result.largest    = slip;
          const Geometry &g = model.initial;
          result.where      = g.vertices[end == 0 ? joint.edge : g.next(joint.edge)];
        }
      stretch(model, joint, Vec2(found.elastic_normal, found.elastic_shear) / load_part, point);
    }
  } // namespace



  BeddingRest stress_bedding_planes(const Model             &model,
                                    const BeddingParameters &bedding,
                                    const bool               under_gravity,
                                    DdaState                &state)
  {
    const Model problem = rest_model(model, bedding);
    DdaState    rest    = initial_state(problem);
    const Vec2  squeezed(load_part * bedding.initial_normal_stress, 0.);
    for (std::size_t j = 0; j < problem.joints.size(); ++j)
      if (problem.joints[j].kind == JointKind::bedding)
        for (SpringState &point : rest.joints[j].points)
          stretch(problem, problem.joints[j], squeezed, point);
    bear_rest(problem, rest);
    BeddingRest result;
    if (under_gravity)
      {
        load(model, state, rest);
        result.equilibrium = settle(problem, rest);
      }

    std::size_t number = 0; // of the joint in the model at rest
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const Joint &joint = model.joints[j];
        if (!joint.within_bedrock())
          continue;
        if (joint.kind == JointKind::bedding)
          for (int end = 0; end < 2; ++end)
            take(model,
                 joint,
                 end,
                 rest.joints[number].points[end],
                 result,
                 state.joints[j].points[end]);
        ++number;
      }
    bear_rest(model, state);
    state.energy = held_energy(model, state);
    return result;
  }
} // namespace hybrid::dda
