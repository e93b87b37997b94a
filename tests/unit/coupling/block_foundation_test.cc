// SPDX-License-Identifier: GPL-3.0-or-later
#include "bedrock_section.h"

#include <hybrid/coupling/block_foundation.h>
#include <hybrid/coupling/coupled_step.h>
#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::coupling;
  using namespace hybrid::test;

  /// Constant acceleration of 2 m/s2 at the outcrop.
  scene::GroundMotion constant_acceleration()
  {
    return {scene::Motion(0.5, {2., 2., 2.}), {}};
  }
} // namespace



TEST(BlockFoundation, sends_twice_the_upgoing_wave_through_the_base)
{
  const scene::SceneParameters p     = bedrock_parameters("triangles");
  const dda::Model             model = dda::build_model(layered_section(2, {2, 1}), p, {});
  BlockFoundation              base({}, constant_acceleration(), p, model);
  CoupledState                 state;
  base.start(state);
  state.time                 = 0.3;
  const Eigen::VectorXd f    = base.predict(state, 0.1).boundary_force;
  const Material       &rock = p.materials.at("rock");
  Vec2                  total(0., 0.);
  for (Eigen::Index k = 0; k < f.size(); k += 2)
    total += f.segment<2>(k);
  EXPECT_NEAR(total.x(), 2. * rock.density * rock.s_wave_speed() * 2. * 0.4, 1e-6);
  EXPECT_NEAR(total.y(), 0., 1e-6);
}



TEST(BlockFoundation, columns_change_no_state_before_the_step_is_accepted)
{
  scene::SceneParameters p = bedrock_parameters("triangles");
  p.continuum.sides        = scene::free_field_side();
  const dda::Model model   = dda::build_model(layered_section(2, {2, 1}), p, {});
  BlockFoundation  base({}, constant_acceleration(), p, model);
  CoupledState     state;
  base.start(state);
  EXPECT_EQ(state.columns.displacement.size(), 2u * 2u * (3u * 2u + 2u));
  const Eigen::VectorXd first  = base.predict(state, 0.1).boundary_force;
  const Eigen::VectorXd second = base.predict(state, 0.1).boundary_force;
  EXPECT_EQ((first - second).norm(), 0.);
  EXPECT_EQ(state.columns.velocity, std::vector<double>(state.columns.velocity.size(), 0.));
  base.correct(state, 0.1, {}, {});
  EXPECT_GT(state.columns.velocity[0], 0.);
}



TEST(BlockFoundation, columns_have_the_joints_of_planes)
{
  scene::SceneParameters p  = bedrock_parameters("triangles");
  p.continuum.sides         = scene::free_field_side();
  p.bedding.shear_stiffness = 1.; // passes nothing on
  const dda::Model model    = dda::build_model(layered_section(2, {2, 1}), p, {});
  BlockFoundation  base({}, constant_acceleration(), p, model);
  CoupledState     state;
  base.start(state);
  double below = 0., above = 0.; // on the plane at y = 2 m, beside the sides
  for (int k = 0; k < 20; ++k)
    {
      const Eigen::VectorXd f = base.predict(state, 1e-3).boundary_force;
      below = above = 0.;
      for (std::size_t e = 0; e < model.boundary.size(); ++e)
        if (model.boundary[e].part != dda::BoundaryPart::base)
          {
            const bool is_above =
              model.boundary[e].ends[0].y() + model.boundary[e].ends[1].y() > 4.;
            (is_above ? above : below) += f.segment<4>(4 * e).norm();
          }
      base.correct(state, 1e-3, {}, {});
      state.time += 1e-3;
    }
  EXPECT_GT(below, 1e3);
  EXPECT_LT(above, 1e-6 * below);
}



/// Its inertia is all that drives the metre of rock above a plane whose strength it needs.
TEST(BlockFoundation, columns_slip_on_planes_as_the_blocks_beside_them_do)
{
  scene::SceneParameters p = bedrock_parameters("triangles");
  p.continuum.sides        = scene::free_field_side();
  p.bedding.slips          = true;
  p.bedding.friction_angle = 30.;
  const dda::Model model   = dda::build_model(layered_section(2, {2, 1}), p, {});
  BlockFoundation  base({}, constant_acceleration(), p, model);
  CoupledState     state;
  base.start(state);
  state.blocks                 = dda::initial_state(model);
  constexpr double compression = 100., dt = 1e-3; // [Pa], [s]
  constexpr int    n_steps = 200;
  for (dda::JointState &joint : state.blocks.joints)
    for (dda::SpringState &point : joint.points)
      point.elastic_normal = compression;
  base.take_rest(state);
  const auto momentum = [&](const int column) { // over the mass; three nodes of degree 2
    const double *above = &state.columns.velocity[2 * (8 * column + 5)];
    return (above[0] + 4. * above[2] + above[4]) / 6.;
  };
  double half[2] = {0., 0.}; // the wave has come long since
  for (int k = 0; k < n_steps; ++k)
    {
      base.predict(state, dt);
      EXPECT_EQ(base.solve_slip(state, dt, {}), continuum::SlipStatus::settled);
      base.correct(state, dt, {}, {});
      state.time += dt;
      for (int column = 0; column < 2 && k + 1 == n_steps / 2; ++column)
        half[column] = momentum(column);
    }
  const double strength = std::tan(M_PI / 6.) * compression, mass = 2220.;
  for (int column = 0; column < 2; ++column)
    {
      const double gained = strength / mass * 0.5 * n_steps * dt;
      EXPECT_NEAR(momentum(column) - half[column], gained, 1e-6 * gained);
      EXPECT_EQ(state.columns.slip[column].condition[0], continuum::PlaneCondition::slipping);
      EXPECT_LT(state.columns.slip[column].jump[1], 0.); // the rock below runs ahead
    }
}



TEST(BlockFoundation, free_field_sides_must_be_vertical)
{
  scene::SceneParameters p = bedrock_parameters("triangles");
  p.continuum.sides        = scene::free_field_side();
  scene::SectionMesh mesh  = layered_section(2, {2, 1});
  mesh.nodes[3].x() -= 0.2; // the left side, one up
  const dda::Model model = dda::build_model(mesh, p, {});
  EXPECT_THROW(BlockFoundation({}, constant_acceleration(), p, model), InputError);
}



/// A square of the mass on a layer: the bedrock bears its weight without moving.
TEST(BlockFoundation, a_mass_at_rest_stays_at_rest)
{
  for (const std::string kind : {"layers", "triangles", "cells"})
    {
      scene::SceneParameters p     = bedrock_parameters(kind);
      p.blocks.enabled             = true;
      p.blocks.belt_material       = "rock";
      p.materials["rock"].cohesion = p.materials["rock"].tensile_strength = 1e6;
      scene::SectionMesh mesh = layered_section(3, {1, 1});
      const int          a    = 2 * 4 + 1; // on the ground
      mesh.nodes.emplace_back(2., 3.);
      mesh.nodes.emplace_back(1., 3.);
      mesh.blocks             = {{a, a + 1, 12, 13}};
      mesh.block_region       = {0};
      mesh.block_region_names = {"sliding_mass"};
      mesh.lines["sliding_surface"].push_back({a, a + 1});
      std::vector<Vec2> nodes;
      for (const int node : scene::cut_bedrock(mesh, p).foundation)
        nodes.push_back(mesh.nodes[node]);
      const dda::Model model = dda::build_model(mesh, p, nodes);
      BlockFoundation  base(nodes, {}, p, model);
      CoupledState     state;
      base.start(state);
      state.blocks                  = dda::initial_state(model);
      const dda::StaticResult start = dda::settle(model, state.blocks, false);
      EXPECT_TRUE(start.equilibrium);
      const double weight = 2220. * 9.81;
      EXPECT_NEAR(state.blocks.bedrock_static_force.reshaped(6, model.n_bedrock).row(1).sum(),
                  -weight,
                  1e-6 * weight);
      const std::vector<Vec2> before = state.blocks.geometry.vertices;
      dda::BlockSolver        solver(model);
      CoupledStep             step(&solver, &base, nullptr);
      for (int k = 0; k < 50; ++k)
        ASSERT_TRUE(step.solve(state, 1e-3).converged);
      for (std::size_t v = 0; v < before.size(); ++v)
        EXPECT_LT((state.blocks.geometry.vertices[v] - before[v]).norm(), 1e-10) << kind;
    }
}
