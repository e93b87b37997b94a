// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  scene::SceneParameters bonded_parameters()
  {
    scene::SceneParameters p             = block_parameters(30.);
    p.blocks.bonded                      = true;
    p.blocks.belt_material               = "belt";
    p.materials["belt"]                  = p.materials["rock"];
    p.materials["belt"].name             = "belt";
    p.materials["belt"].friction_angle   = 12.;
    p.materials["belt"].cohesion         = 1e4;
    p.materials["rock"].tensile_strength = 1e5;
    return p;
  }

  /// Squares whose lower side is the line "sliding_surface".
  scene::SectionMesh squares_on_surface(const int columns, const int rows)
  {
    scene::SectionMesh mesh = square_blocks(columns, rows);
    for (int i = 0; i < columns; ++i)
      mesh.lines["sliding_surface"].push_back({i, i + 1});
    return mesh;
  }
} // namespace



TEST(ModelBuilder, blocks_have_the_mass_and_moments_of_their_polygons)
{
  const Model model = build_model(square_blocks(1, 1, 2.), block_parameters(30.), {});
  ASSERT_EQ(model.n_blocks(), 1);
  const BlockProperties &p = model.blocks[0];
  EXPECT_NEAR(p.area, 4., 1e-14);
  EXPECT_NEAR(p.size, 2., 1e-14);
  EXPECT_NEAR(p.mass, 4. * 2220., 1e-10);
  EXPECT_NEAR(p.sxx, 2220. * 16. / 12., 1e-10);
  EXPECT_NEAR(p.sxy, 0., 1e-10);
}



TEST(ModelBuilder, loose_blocks_have_no_joints_bonded_blocks_one_for_each_shared_edge)
{
  EXPECT_EQ(build_model(square_blocks(3, 2), block_parameters(30.), {}).joints.size(), 0u);
  scene::SceneParameters p = block_parameters(30.);
  p.blocks.bonded          = true;
  EXPECT_EQ(build_model(square_blocks(3, 2), p, {}).joints.size(), 2u * 2u + 3u);
}



TEST(ModelBuilder, ends_of_a_joint_coincide)
{
  const Model model =
    build_model(squares_on_surface(3, 2), bonded_parameters(), straight_foundation(0., 0., 3., 6));
  const Geometry &g = model.initial;
  EXPECT_EQ(model.joints.size(), 7u + 6u); // two foundation segments below each block
  for (const Joint &joint : model.joints)
    for (const Joint::Point &point : joint.points)
      {
        const Vec2 a = g.vertices[joint.edge], b = g.vertices[g.next(joint.edge)];
        const Vec2 other = joint.other == foundation_body ? g.foundation_nodes[point.other_vertex]
                                                          : g.vertices[point.other_vertex];
        EXPECT_LT((a + point.position * (b - a) - other).norm(), 1e-14);
      }
}



TEST(ModelBuilder, stiffness_of_a_joint_is_the_penalty_ratio_times_E_over_h)
{
  const Model model =
    build_model(squares_on_surface(2, 1), bonded_parameters(), straight_foundation(0., 0., 2., 2));
  for (const Joint &joint : model.joints)
    EXPECT_NEAR(joint.law.normal_stiffness(), 40. * 50e6 / 2., 1e-3);
}



TEST(ModelBuilder, weaker_strength_of_the_belt_holds_on_the_sliding_surface_only)
{
  const Model model =
    build_model(squares_on_surface(2, 1), bonded_parameters(), straight_foundation(0., 0., 2., 2));
  for (const Joint &joint : model.joints)
    {
      const double        normal = 1e5, gap = -normal / joint.law.normal_stiffness();
      const JointResponse r = joint.law.respond({gap, 1.}, {});
      EXPECT_NEAR(-r.shear,
                  joint.other == foundation_body ? 1e4 + normal * std::tan(12. * M_PI / 180.)
                                                 : normal * std::tan(30. * M_PI / 180.),
                  1e-6 * normal);
    }
}



TEST(ModelBuilder, saturated_material_below_the_water_level)
{
  scene::SceneParameters p          = block_parameters(30.);
  p.materials["wet"]                = p.materials["rock"];
  p.materials["wet"].name           = "wet";
  p.materials["wet"].density        = 2400.;
  p.materials["wet"].weight_density = 1400.;
  p.blocks.saturated_material       = "wet";
  p.environment.water_level         = 1.;
  const Model model                 = build_model(square_blocks(1, 2), p, {});
  EXPECT_TRUE(model.blocks[0].saturated);
  EXPECT_FALSE(model.blocks[1].saturated);
  EXPECT_NEAR(model.blocks[0].mass, 2400., 1e-9);
  EXPECT_NEAR(model.blocks[0].weight, 1400., 1e-9);
  EXPECT_NEAR(model.blocks[1].weight, 2220., 1e-9);
}



TEST(ModelBuilder, stiffness_correction_takes_off_the_joints_compliance)
{
  scene::SceneParameters p         = bonded_parameters();
  const Model            corrected = build_model(square_blocks(3, 3), p, {});
  p.blocks.stiffness_correction    = false;
  const Model plain                = build_model(square_blocks(3, 3), p, {});
  // the middle block: half of four edges of 1 m with k = 40 E / 2 m
  const double density = 2., k = 20. * 50e6;
  EXPECT_NEAR(1. / corrected.blocks[4].elasticity(2, 2) + density / k,
              1. / plain.blocks[4].elasticity(2, 2),
              1e-15);
}



TEST(ModelBuilder, surface_without_its_node_in_the_bedrock_is_refused)
{
  try
    {
      build_model(squares_on_surface(2, 1),
                  bonded_parameters(),
                  straight_foundation(0., 0.5, 2.5, 2));
      FAIL() << "accepted";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("sliding_surface"), std::string::npos);
    }
}



TEST(ModelBuilder, initial_state_is_at_rest_and_unstressed)
{
  const Model model =
    build_model(square_blocks(2, 1), block_parameters(30.), straight_foundation(0., 1., 3., 2));
  const DdaState state = initial_state(model);
  EXPECT_LT((state.blocks[1].centroid - Vec2(1.5, 0.5)).norm(), 1e-14);
  EXPECT_EQ(state.blocks[0].velocity.norm(), 0.);
  EXPECT_EQ(state.blocks[0].stress.norm(), 0.);
  EXPECT_EQ(state.foundation_displacement.size(), 6);
}



TEST(ModelBuilder, factors_of_a_heterogeneous_scene_belong_to_the_place)
{
  scene::SceneParameters p       = block_parameters(30.);
  p.blocks.bonded                = true;
  p.materials["rock"].cohesion   = 1e5;
  p.heterogeneity.modulus_shape  = 3.;
  p.heterogeneity.strength_shape = 3.;
  scene::SectionMesh mesh        = square_blocks(4, 3);
  const Model        model       = build_model(mesh, p, {});
  std::reverse(mesh.blocks.begin(), mesh.blocks.end());
  const Model reversed = build_model(mesh, p, {});

  const int n = model.n_blocks();
  for (int b = 0; b < n; ++b)
    {
      EXPECT_EQ(model.blocks[b].modulus_factor, reversed.blocks[n - 1 - b].modulus_factor);
      EXPECT_NE(model.blocks[b].modulus_factor, model.blocks[(b + 1) % n].modulus_factor);
    }
  ASSERT_EQ(model.joints.size(), reversed.joints.size());
  std::vector<double> factors, others;
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    {
      factors.push_back(model.joints[j].strength_factor);
      others.push_back(reversed.joints[j].strength_factor);
      // slip far beyond the elastic part: the cohesion is left, without softening
      const JointResponse r = model.joints[j].law.respond({0., 1e-2}, {});
      EXPECT_LE(-r.shear, 1e5 * factors.back() * (1. + 1e-12));
      EXPECT_GT(-r.shear, 0.8e5 * factors.back());
    }
  std::sort(factors.begin(), factors.end());
  std::sort(others.begin(), others.end());
  EXPECT_EQ(factors, others);
}



TEST(ModelBuilder, modulus_factor_scales_the_stiffness_of_block_and_joint)
{
  scene::SceneParameters p      = block_parameters(30.);
  p.blocks.bonded               = true;
  p.blocks.stiffness_correction = false;
  const Model uniform           = build_model(square_blocks(2, 1), p, {});
  p.heterogeneity.modulus_shape = 4.;
  const Model  varied           = build_model(square_blocks(2, 1), p, {});
  const double f0 = varied.blocks[0].modulus_factor, f1 = varied.blocks[1].modulus_factor;
  for (int b = 0; b < 2; ++b)
    EXPECT_LT((varied.blocks[b].elasticity -
               varied.blocks[b].modulus_factor * uniform.blocks[b].elasticity)
                .norm(),
              1e-9 * uniform.blocks[b].elasticity.norm());
  EXPECT_NEAR(varied.joints[0].law.normal_stiffness() / uniform.joints[0].law.normal_stiffness(),
              std::min(f0, f1),
              1e-12);
  EXPECT_EQ(varied.joints[0].strength_factor, 1.);
}



TEST(ModelBuilder, water_acts_where_the_scene_says_so)
{
  scene::SceneParameters p    = block_parameters(30.);
  p.environment.water_level   = 7.;
  p.environment.water_density = 1025.;
  EXPECT_EQ(build_model(square_blocks(1, 1), p, {}).water.action, Water::Action::none);
  p.environment.water_method = scene::WaterMethod::submerged;
  const Model model          = build_model(square_blocks(1, 1), p, {});
  EXPECT_EQ(model.water.action, Water::Action::buoyancy);
  EXPECT_EQ(model.water.level, 7.);
  EXPECT_NEAR(model.water.unit_weight, 1025. * 9.81, 1e-9);
  p.environment.water_method = scene::WaterMethod::pressures;
  EXPECT_EQ(build_model(square_blocks(1, 1), p, {}).water.action, Water::Action::pressures);
}
