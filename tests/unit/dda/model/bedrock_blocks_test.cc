// SPDX-License-Identifier: GPL-3.0-or-later
#include "bedrock_section.h"

#include <hybrid/dda/failure/joint_failure.h>
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  double area_of(const scene::SectionMesh &mesh, const std::vector<int> &outline)
  {
    std::vector<Vec2> points;
    for (const int node : outline)
      points.push_back(mesh.nodes[node]);
    EXPECT_TRUE(is_simple(points.data(), static_cast<int>(points.size())));
    return polygon_moments(points.data(), static_cast<int>(points.size())).area;
  }
} // namespace



TEST(BedrockBlocks, layers_are_the_boundary_loops_of_their_surfaces_on_the_lowest)
{
  const scene::SectionMesh   mesh   = layered_section(4, {2, 1, 3});
  const scene::BedrockBlocks layers = cut_bedrock(mesh, bedrock_parameters("layers"));
  ASSERT_EQ(layers.outlines.size(), 2u);
  EXPECT_NEAR(area_of(mesh, layers.outlines[0]), 4. * 1., 1e-14);
  EXPECT_NEAR(area_of(mesh, layers.outlines[1]), 4. * 3., 1e-14);
  EXPECT_EQ(layers.outlines[0].size(), 2u * (4 + 1));
  ASSERT_EQ(layers.foundation.size(), 5u);
  for (int i = 0; i <= 4; ++i)
    EXPECT_LT((mesh.nodes[layers.foundation[i]] - Vec2(i, 2.)).norm(), 1e-14);
}



TEST(BedrockBlocks, a_layer_with_a_hole_is_refused)
{
  scene::SectionMesh mesh             = layered_section(5, {1, 5});
  mesh.bedrock_surface[5 + 2 * 5 + 2] = 7; // an island in the second layer
  EXPECT_THROW(cut_bedrock(mesh, bedrock_parameters("layers")), InputError);
}



TEST(BedrockBlocks, a_plane_that_cuts_no_layer_off_is_refused)
{
  scene::SectionMesh mesh = layered_section(4, {2, 2});
  cut_bedrock(mesh, bedrock_parameters("layers"));
  mesh.bedrock_surface.assign(mesh.bedrock_cells.size(), 1); // the plane lies within one surface
  try
    {
      cut_bedrock(mesh, bedrock_parameters("layers"));
      FAIL() << "accepted";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(
        std::string(error.what()).find("bedding_1 does not divide the bedrock at (0.500000, 2.0"),
        std::string::npos)
        << error.what();
    }
  mesh = layered_section(4, {2, 2, 1});
  for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
    mesh.bedrock_surface[c] = mesh.bedrock_surface[c] == 2 ? 1 : mesh.bedrock_surface[c];
  EXPECT_THROW(cut_bedrock(mesh, bedrock_parameters("layers")), InputError); // one of two
}



TEST(BedrockBlocks, triangles_fill_the_cells_with_alternating_diagonals)
{
  const scene::SectionMesh   mesh      = layered_section(4, {4});
  const scene::BedrockBlocks triangles = cut_bedrock(mesh, bedrock_parameters("triangles"));
  ASSERT_EQ(triangles.outlines.size(), 2u * 16u);
  EXPECT_TRUE(triangles.foundation.empty());
  std::vector<int> meeting(mesh.nodes.size(), 0);
  for (const auto &outline : triangles.outlines)
    {
      EXPECT_NEAR(area_of(mesh, outline), 0.5, 1e-14);
      for (const int node : outline)
        ++meeting[node];
    }
  for (int j = 1; j < 4; ++j)
    for (int i = 1; i < 4; ++i)
      {
        const int n = meeting[j * 5 + i];
        EXPECT_TRUE(n == 4 || n == 8) << n << " triangles meet at " << i << ", " << j;
      }
}



TEST(BedrockBlocks, oblique_cells_are_cut_along_the_shorter_diagonal)
{
  scene::SectionMesh mesh      = layered_section(1, {1});
  mesh.nodes[3]                = Vec2(1.5, 1.);
  const scene::BedrockBlocks b = cut_bedrock(mesh, bedrock_parameters("triangles"));
  for (const auto &outline : b.outlines)
    EXPECT_EQ(std::count(outline.begin(), outline.end(), 1) +
                std::count(outline.begin(), outline.end(), 2),
              2);
}



TEST(BedrockBlocks, joints_are_welds_but_for_the_planes_of_the_scene)
{
  scene::SceneParameters p     = bedrock_parameters("triangles");
  const auto             mesh  = layered_section(4, {2, 2});
  const Model            model = build_model(mesh, p, {});
  EXPECT_EQ(model.n_bedrock, 32);
  int bedding = 0;
  for (const Joint &joint : model.joints)
    {
      ASSERT_TRUE(joint.within_bedrock());
      if (joint.kind != JointKind::bedding)
        continue;
      ++bedding;
      EXPECT_EQ(joint.law.normal_stiffness(), p.bedding.normal_stiffness);
      EXPECT_EQ(joint.law.shear_stiffness(), p.bedding.shear_stiffness);
    }
  EXPECT_EQ(bedding, 4);
  EXPECT_EQ(model.joints.size(), 16u + 2u * 12u); // diagonals, inner edges
  for (const BlockProperties &block : model.blocks)
    EXPECT_EQ(block.weight, 0.);
  EXPECT_EQ(model.boundary.size(), 3u * 4u);
}



TEST(BedrockBlocks, planes_with_strength_are_no_failed_joints)
{
  scene::SceneParameters p = bedrock_parameters("triangles");
  p.bedding.slips          = true;
  const Model model        = build_model(layered_section(4, {2, 2}), p, {});
  for (const Joint &joint : model.joints)
    {
      EXPECT_EQ(joint.plane, joint.kind == JointKind::bedding ? 0 : -1);
      JointState state;
      for (SpringState &point : state.points)
        point.history.damage = 1.;
      update_failure(joint, 1., state);
      EXPECT_EQ(state.failure == FailureKind::none, joint.kind == JointKind::bedding);
      EXPECT_FALSE(state.released);
    }
}



TEST(BedrockBlocks, another_model_is_a_cut_and_a_line)
{
  const scene::SectionMesh mesh  = layered_section(4, {2, 1});
  const Model              model = build_model(mesh, bedrock_parameters("cells"), {});
  EXPECT_EQ(model.n_bedrock, 12);
  int welds = 0, planes = 0;
  for (const Joint &joint : model.joints)
    (joint.kind == JointKind::bedding ? planes : welds) += 1;
  EXPECT_EQ(planes, 4);
  EXPECT_EQ(welds, 3 * 3 + 4); // upright ones in three rows, level ones within the lower layer
  EXPECT_EQ(model.boundary.size(), 2u * 3u + 4u) << "sides and a compliant base";
}
