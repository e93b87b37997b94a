// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  const double steep = 40. * M_PI / 180., gentle = 10. * M_PI / 180.;

  Vec2 along(const double angle, const double length)
  {
    return length * Vec2(std::cos(angle), -std::sin(angle));
  }



  scene::SceneParameters without_cohesion()
  {
    scene::SceneParameters p = block_parameters(20., 5e9);
    p.blocks.bonded          = true;
    p.blocks.belt_material   = "rock";
    p.blocks.damping_ratio   = 0.02;
    return p;
  }



  /// A block of 4 m x 2 m on the steep part of the ground, its toe where that gets gentle.
  scene::SectionMesh block_above_a_bend()
  {
    scene::SectionMesh mesh;
    const Vec2         up = 2. * Vec2(std::sin(steep), std::cos(steep)), heel = -along(steep, 4.);
    mesh.nodes                    = {heel, {0., 0.}, up, heel + up};
    mesh.blocks                   = {{0, 1, 2, 3}};
    mesh.block_region             = {0};
    mesh.block_region_names       = {"sliding_mass"};
    mesh.lines["sliding_surface"] = {{0, 1}};
    return mesh;
  }



  std::vector<Vec2> bent_ground()
  {
    return {-along(steep, 20.), -along(steep, 4.), {0., 0.}, along(gentle, 60.)};
  }



  /// How deep the toe is below the gentle part [m].
  double sunk(const DdaState &state)
  {
    const Vec2 toe = state.geometry.vertices[1];
    return -toe.dot(Vec2(std::sin(gentle), std::cos(gentle)));
  }
} // namespace



TEST(JointValleys, the_ground_rises_where_a_block_slides_to)
{
  const Model model = build_model(block_above_a_bend(), without_cohesion(), bent_ground());
  ASSERT_EQ(model.joints.size(), 1u);
  // The ground slips backwards along the block that slides to the right.
  EXPECT_NEAR(model.joints[0].valley[1], std::sin(steep - gentle), 1e-12);
  EXPECT_EQ(model.joints[0].valley[0], 0.);
}



TEST(JointValleys, convex_blocks_have_none_and_an_edge_that_is_bonded_too_is_none)
{
  scene::SectionMesh mesh = square_blocks(2, 2);
  for (const Joint &joint :
       build_model(mesh, without_cohesion(), straight_foundation(0., 1., 3.)).joints)
    EXPECT_EQ(joint.valley[0] + joint.valley[1], 0.);

  // Three squares as one angle, and the fourth one that fills it: both of its edges are bonded.
  mesh.blocks        = {{0, 1, 2, 5, 4, 7, 6, 3}, {4, 5, 8, 7}};
  mesh.block_region  = {0, 0};
  const Model filled = build_model(mesh, without_cohesion(), straight_foundation(0., 1., 3.));
  ASSERT_EQ(filled.joints.size(), 2u);
  for (const Joint &joint : filled.joints)
    EXPECT_EQ(joint.valley[0] + joint.valley[1], 0.);

  // Without the edge that it leans on.
  mesh.nodes.push_back({1., 2.});
  mesh.blocks[1].back() = 9;
  const Model open      = build_model(mesh, without_cohesion(), straight_foundation(0., 1., 3.));
  ASSERT_EQ(open.joints.size(), 1u);
  EXPECT_EQ(std::max(open.joints[0].valley[0], open.joints[0].valley[1]), 1.);
  EXPECT_EQ(std::min(open.joints[0].valley[0], open.joints[0].valley[1]), 0.);
}



TEST(JointValleys, a_block_on_a_belt_does_not_sink_into_a_bend_of_the_ground)
{
  FixedBaseRun run(block_above_a_bend(), without_cohesion(), bent_ground());
  double       deepest = 0.;
  while (run.state.time < 0.6)
    {
      ASSERT_TRUE(run.advance(1e-3, 10));
      deepest = std::max(deepest, sunk(run.state));
    }
  EXPECT_GT(deepest, 0.5 * 0.0025 * 4.);
  EXPECT_LT(deepest, 1.5 * 0.0025 * 4.); // 0.05 m without a look at the next edge
}



TEST(JointValleys, a_bonded_block_does_not_sink_into_a_bend_of_its_neighbour)
{
  // The ground of above as a block.
  scene::SectionMesh mesh = block_above_a_bend();
  mesh.lines.clear();
  const Vec2 end = along(gentle, 12.);
  mesh.nodes.insert(mesh.nodes.end(),
                    {-along(steep, 8.), {-along(steep, 8.).x(), -8.}, {end.x(), -8.}, end});
  mesh.blocks              = {{0, 1, 2, 3}, {4, 5, 6, 7, 1, 0}};
  mesh.block_region        = {0, 0};
  scene::SceneParameters p = without_cohesion();
  p.blocks.belt_material.clear();
  FixedBaseRun run(mesh, p, {{-20., -8.}, {30., -8.}});
  double       deepest = 0.;
  while (run.state.time < 0.6)
    {
      ASSERT_TRUE(run.advance(1e-3, 10));
      deepest = std::max(deepest, sunk(run.state));
    }
  EXPECT_LT(deepest, 1.5 * 0.0025 * 4.); // 0.2 m without
}
