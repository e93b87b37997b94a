// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/rock_mesh.h>
#include <hybrid/scene/input_error.h>

#include "rectangle_mesh.h"

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  /// 4 x 4 unit cells; node (i, j) is 5 j + i.
  scene::SectionMesh square()
  {
    return test::rectangle_mesh(test::equal_spacing(0., 4., 4), test::equal_spacing(0., 4., 4));
  }

  int copies(const RockMesh &rock, const int origin)
  {
    return static_cast<int>(std::count(rock.origin.begin(), rock.origin.end(), origin));
  }
} // namespace


TEST(RockMesh, weld_without_names)
{
  auto mesh               = square();
  mesh.lines["bedding_1"] = {{10, 11}, {11, 12}};
  const auto rock         = split_bedding_planes(mesh, {});
  EXPECT_EQ(rock.nodes.size(), 25u);
  EXPECT_TRUE(rock.joints.empty());
}


TEST(RockMesh, plane_through_the_model_doubles_every_node)
{
  auto mesh               = square();
  mesh.lines["bedding_1"] = {{10, 11}, {11, 12}, {12, 13}, {13, 14}};
  const auto rock         = split_bedding_planes(mesh, {"bedding_1"});
  EXPECT_EQ(rock.nodes.size(), 30u);
  EXPECT_EQ(rock.joints.size(), 4u);
  for (const auto &pair : rock.joints)
    {
      EXPECT_NE(pair.first.a, pair.second.a);
      EXPECT_EQ(rock.nodes[pair.first.a], rock.nodes[pair.second.a]);
      EXPECT_EQ(rock.nodes[pair.first.b], rock.nodes[pair.second.b]);
    }
  // Both halves of a side still bound the rock.
  EXPECT_EQ(boundary_faces(rock, mesh.lines["left"]).size(), 4u);
}


TEST(RockMesh, end_inside_the_rock_keeps_one_node)
{
  auto mesh               = square();
  mesh.lines["bedding_1"] = {{10, 11}, {11, 12}, {12, 13}};
  const auto rock         = split_bedding_planes(mesh, {"bedding_1"});
  EXPECT_EQ(copies(rock, 10), 2);
  EXPECT_EQ(copies(rock, 11), 2);
  EXPECT_EQ(copies(rock, 12), 2);
  EXPECT_EQ(copies(rock, 13), 1);
  EXPECT_EQ(rock.joints.size(), 3u);
}


TEST(RockMesh, single_edge_inside_the_rock_cannot_open)
{
  auto mesh               = square();
  mesh.lines["bedding_1"] = {{11, 12}};
  const auto rock         = split_bedding_planes(mesh, {"bedding_1"});
  EXPECT_EQ(rock.nodes.size(), 25u);
  EXPECT_TRUE(rock.joints.empty());
}


TEST(RockMesh, crossing_planes_give_four_nodes)
{
  auto mesh               = square();
  mesh.lines["bedding_1"] = {{10, 11}, {11, 12}, {12, 13}, {13, 14}};
  mesh.lines["bedding_2"] = {{2, 7}, {7, 12}, {12, 17}, {17, 22}};
  const auto rock         = split_bedding_planes(mesh, {"bedding_1", "bedding_2"});
  EXPECT_EQ(copies(rock, 12), 4);
  EXPECT_EQ(rock.nodes.size(), 25u + 8u + 3u);
  EXPECT_EQ(rock.joints.size(), 8u);
}


TEST(RockMesh, plane_that_ends_on_another_gives_three_nodes)
{
  auto mesh               = square();
  mesh.lines["bedding_1"] = {{10, 11}, {11, 12}, {12, 13}, {13, 14}};
  mesh.lines["bedding_2"] = {{2, 7}, {7, 12}};
  const auto rock         = split_bedding_planes(mesh, {"bedding_1", "bedding_2"});
  EXPECT_EQ(copies(rock, 12), 3);
}


TEST(RockMesh, surface_chain_runs_from_left_to_right_over_an_outcrop)
{
  auto mesh               = square();
  mesh.lines["bedding_1"] = {{22, 17}, {17, 12}};
  const auto rock         = split_bedding_planes(mesh, {"bedding_1"});
  const auto chain        = surface_chain(rock, boundary_faces(rock, mesh.lines["ground"]));
  ASSERT_EQ(chain.size(), 4u);
  for (int i = 0; i < 4; ++i)
    {
      EXPECT_DOUBLE_EQ(rock.nodes[chain[i].b].x(), i);
      EXPECT_DOUBLE_EQ(rock.nodes[chain[i].a].x(), i + 1.);
    }
  EXPECT_NE(chain[1].a, chain[2].b); // two nodes at the outcrop
  EXPECT_EQ(rock.nodes[chain[1].a], rock.nodes[chain[2].b]);
}


TEST(RockMesh, broken_surface_is_refused)
{
  auto mesh = square();
  mesh.lines["ground"].erase(mesh.lines["ground"].begin() + 1);
  const auto rock = split_bedding_planes(mesh, {});
  try
    {
      surface_chain(rock, boundary_faces(rock, mesh.lines["ground"]));
      FAIL();
    }
  catch (const InputError &error)
    {
      const std::string text = error.what();
      for (const char *part : {"one path from side to side", " m. Fill an opening at a side"})
        EXPECT_NE(text.find(part), std::string::npos) << text;
    }
}


TEST(RockMesh, unknown_plane_and_inverted_cell_are_refused)
{
  auto mesh = square();
  EXPECT_THROW(split_bedding_planes(mesh, {"bedding_7"}), InputError);
  std::swap(mesh.bedrock_cells[3][1], mesh.bedrock_cells[3][3]);
  EXPECT_THROW(split_bedding_planes(mesh, {}), InputError);
}
