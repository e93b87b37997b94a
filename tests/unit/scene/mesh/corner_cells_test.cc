// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/corner_cells.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// A step of 1 m: two cells below, one above the left one; its toe is node 4. The ground is a
    /// line from node 6 over the toe to node 5, of edges as long as the lower cells are wide and
    /// @p height.
    SectionMesh a_step(const double width, const double height)
    {
      SectionMesh mesh;
      mesh.nodes           = {{0., 0.},
                              {width, 0.},
                              {2. * width, 0.},
                              {0., 1.},
                              {width, 1.},
                              {2. * width, 1.},
                              {0., 1. + height},
                              {width, 1. + height}};
      mesh.bedrock_cells   = {{{0, 1, 4, 3}}, {{1, 2, 5, 4}}, {{3, 4, 7, 6}}};
      mesh.bedrock_region  = {0, 1, 2};
      mesh.bedrock_surface = {5, 6, 7};
      mesh.lines["ground"] = {{{6, 7}}, {{7, 4}}, {{4, 5}}};
      return mesh;
    }



    double area(const SectionMesh &mesh, const std::array<int, 4> &cell)
    {
      double result = 0.;
      for (std::size_t i = 0; i < 4; ++i)
        {
          const Vec2 &a = mesh.nodes[cell[i]], &b = mesh.nodes[cell[(i + 1) % 4]];
          result += 0.5 * (a.x() * b.y() - a.y() * b.x());
        }
      return result;
    }



    TEST(CornerCells, are_halved_towards_the_toe_of_a_step)
    {
      SectionMesh mesh = a_step(1., 1.);
      halve_corner_cells(mesh, 2);
      ASSERT_EQ(mesh.bedrock_cells.size(), 3u + 2u * 6u);
      double sum = 0.;
      for (const auto &cell : mesh.bedrock_cells)
        {
          EXPECT_GT(area(mesh, cell), 0.01);
          sum += area(mesh, cell);
        }
      EXPECT_NEAR(sum, 3., 1e-12);
      const auto corners = corners_of_bedrock(mesh);
      ASSERT_EQ(corners.size(), 1u);
      EXPECT_EQ(corners[0].node, 4);
      EXPECT_NEAR(corners[0].turn, M_PI / 2., 1e-12);
      EXPECT_EQ(corners[0].edge[0], 0.25);
      EXPECT_EQ(corners[0].edge[1], 0.25);
    }



    TEST(CornerCells, have_the_region_of_their_cell_and_lines_go_on_through_new_nodes)
    {
      SectionMesh mesh = a_step(1., 1.);
      halve_corner_cells(mesh, 1);
      EXPECT_EQ(mesh.bedrock_region, (std::vector<int>{0, 1, 2, 0, 0, 1, 1, 2, 2}));
      EXPECT_EQ(mesh.bedrock_surface, (std::vector<int>{5, 6, 7, 5, 5, 6, 6, 7, 7}));
      const auto &ground = mesh.lines["ground"];
      ASSERT_EQ(ground.size(), 5u);
      for (std::size_t i = 0; i + 1 < ground.size(); ++i)
        EXPECT_EQ(ground[i][1], ground[i + 1][0]);
      EXPECT_EQ(mesh.nodes[ground[1][1]], Vec2(1., 1.5));
      EXPECT_EQ(mesh.nodes[ground[3][1]], Vec2(1.5, 1.));
    }



    TEST(CornerCells, stay_where_a_block_is_and_where_the_ground_hardly_turns)
    {
      SectionMesh mesh = a_step(1., 1.);
      mesh.nodes.push_back({2., 2.});
      mesh.blocks = {{4, 5, 8}};
      halve_corner_cells(mesh, 1);
      EXPECT_EQ(mesh.bedrock_cells.size(), 3u);
      SectionMesh bend = a_step(1., 1.);
      bend.bedrock_cells.pop_back();
      bend.nodes[5].y() = 1.1; // 6 degrees
      halve_corner_cells(bend, 1);
      EXPECT_EQ(bend.bedrock_cells.size(), 2u);
    }



    TEST(CornerCells, are_kept_where_a_slope_is_one_cell_long_in_both_meshes)
    {
      const auto corners = corners_of_bedrock(a_step(1., 1.));
      EXPECT_TRUE(keeps_corner_cells(corners, corners_of_bedrock(a_step(1., 2.))));
      EXPECT_FALSE(keeps_corner_cells(corners, {}));
      SectionMesh coarser = a_step(2., 2.);
      for (Vec2 &node : coarser.nodes)
        node -= Vec2(1., 0.); // the same toe
      EXPECT_FALSE(keeps_corner_cells(corners, corners_of_bedrock(coarser)));
    }
  } // namespace
} // namespace hybrid::scene
