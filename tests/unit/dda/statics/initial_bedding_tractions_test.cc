// SPDX-License-Identifier: GPL-3.0-or-later
#include "bedrock_section.h"

#include <hybrid/dda/model/model_builder.h>
#include <hybrid/dda/statics/initial_bedding_tractions.h>
#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/scene/boundary/fixed_base.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  constexpr int n_columns = 6;

  /// Layers of three rows each on two planes with strength; p_0 = 1 kPa.
  struct Case
  {
    scene::SectionMesh     mesh = layered_section(n_columns, {3, 3, 3});
    scene::SceneParameters scene;
    Model                  model;
    DdaState               state;

    explicit Case(const std::string &kind, const double slope = 0.)
      : scene(bedrock_parameters(kind))
    {
      for (Vec2 &node : mesh.nodes)
        node.y() += slope * node.x();
      scene.continuum.base                = scene::fixed_base();
      scene.environment.gravity           = 10.;
      scene.bedding.names                 = {"bedding_1", "bedding_2"};
      scene.bedding.slips                 = true;
      scene.bedding.friction_angle        = 30.;
      scene.bedding.cohesion              = 1e4;
      scene.bedding.tensile_strength      = 1e3;
      scene.bedding.initial_normal_stress = 1e3;
    }

    BeddingRest rest(const bool under_gravity = true)
    {
      std::vector<Vec2> nodes;
      for (const int node : cut_bedrock(mesh, scene).foundation)
        nodes.push_back(mesh.nodes[node]);
      model = build_model(mesh, scene, nodes);
      state = initial_state(model);
      if (scene.blocks.enabled)
        {
          EXPECT_TRUE(settle(model, state).equilibrium);
        }
      return stress_bedding_planes(mesh, scene, model, under_gravity, state);
    }

    /// Mean of what @p value makes of the ends of a plane's joints.
    template <typename Value>
    double mean(const int plane, const Value &value) const
    {
      double sum = 0.;
      int    n   = 0;
      for (std::size_t j = 0; j < model.joints.size(); ++j)
        for (int end = 0; end < 2 && model.joints[j].plane == plane; ++end, ++n)
          sum += value(state.joints[j].points[end]);
      EXPECT_EQ(n, 2 * n_columns);
      return sum / n;
    }

    double normal(const int plane) const
    {
      return mean(plane, [](const SpringState &point) { return point.normal; });
    }
  };
} // namespace



TEST(BeddingRest, planes_carry_the_weight_above_them_and_the_initial_stress)
{
  for (const char *kind : {"layers", "triangles"})
    {
      Case              c(kind);
      const BeddingRest rest    = c.rest();
      const double      density = c.scene.materials.at("rock").density;
      EXPECT_TRUE(rest.equilibrium);
      EXPECT_EQ(rest.slipping + rest.open, 0);
      for (int plane = 0; plane < 2; ++plane)
        {
          const double weight = density * 10. * 3. * (2 - plane);
          EXPECT_NEAR(c.normal(plane), weight + 1e3, 1e-4 * weight) << kind;
          EXPECT_NEAR(c.mean(plane, [](const SpringState &p) { return p.shear; }),
                      0.,
                      1e-3 * weight);
        }
    }
}



TEST(BeddingRest, below_water_planes_bear_effective_stress)
{
  Case dry("layers"), wet("layers");
  wet.scene.environment.water_method  = scene::WaterMethod::pressures;
  wet.scene.environment.water_level   = 12.; // 3 m above the ground
  wet.scene.environment.water_density = 1000.;
  dry.rest();
  wet.rest();
  for (int plane = 0; plane < 2; ++plane) // at 3 and 6 m
    {
      const double load = 1000. * 10. * 3., pore = 1000. * 10. * (9. - 3. * plane);
      EXPECT_NEAR(wet.normal(plane) - dry.normal(plane), load - pore, 10.);
    }
}



TEST(BeddingRest, a_mass_on_the_ground_presses_on_the_planes)
{
  for (const char *kind : {"layers", "triangles"})
    {
      Case c(kind);
      c.scene.blocks.enabled          = true;
      c.scene.blocks.bonded           = false;
      c.mesh.lines["sliding_surface"] = c.mesh.lines["ground"];
      c.mesh.lines.erase("ground");
      c.mesh.block_region_names = {"sliding_mass"};
      const int top = 9 * (n_columns + 1), above = static_cast<int>(c.mesh.nodes.size());
      for (int i = 0; i <= n_columns; ++i)
        c.mesh.nodes.emplace_back(i, 10.);
      for (int i = 0; i < n_columns; ++i)
        {
          c.mesh.blocks.push_back({top + i, top + i + 1, above + i + 1, above + i});
          c.mesh.block_region.push_back(0);
        }
      c.rest();
      const double weight = c.scene.materials.at("rock").density * 10.;
      for (int plane = 0; plane < 2; ++plane)
        EXPECT_NEAR(c.normal(plane), weight * (3. * (2 - plane) + 1.) + 1e3, 1e-3 * weight) << kind;
    }
}



TEST(BeddingRest, the_blocks_bear_the_tractions_and_stay_at_rest)
{
  for (const char *kind : {"layers", "triangles"})
    {
      Case c(kind, 0.3);
      c.rest();
      for (const BlockState &block : c.state.blocks)
        {
          EXPECT_EQ(block.acceleration.norm(), 0.);
          EXPECT_EQ(block.velocity.norm(), 0.);
        }
      EXPECT_GT(c.state.energy.springs, 0.);
      EXPECT_EQ(c.state.energy.bedding_loss, 0.);
    }
}



TEST(BeddingRest, without_gravity_there_is_the_initial_stress_alone)
{
  Case              c("layers");
  const BeddingRest rest = c.rest(false);
  EXPECT_TRUE(rest.equilibrium);
  for (std::size_t j = 0; j < c.model.joints.size(); ++j)
    if (c.model.joints[j].kind == JointKind::bedding)
      for (const SpringState &point : c.state.joints[j].points)
        {
          EXPECT_NEAR(point.normal, 1e3, 1e-9);
          EXPECT_EQ(point.shear, 0.);
        }
}



TEST(BeddingRest, steep_planes_slip_until_the_tractions_are_within_the_strength)
{
  Case c("triangles", 0.3);
  c.scene.bedding.friction_angle = 2.;
  c.scene.bedding.cohesion       = 100.;
  const BeddingRest rest         = c.rest();
  EXPECT_TRUE(rest.equilibrium);
  EXPECT_GT(rest.slipping, n_columns);
  EXPECT_GT(rest.largest, 0.);
  const double tan_phi = std::tan(2. * M_PI / 180.);
  for (std::size_t j = 0; j < c.model.joints.size(); ++j)
    if (c.model.joints[j].kind == JointKind::bedding)
      for (const SpringState &point : c.state.joints[j].points)
        {
          EXPECT_LE(std::abs(point.shear), 100. + tan_phi * point.normal + 1e-3);
          EXPECT_EQ(point.history.plastic_slip, 0.);
        }
}
