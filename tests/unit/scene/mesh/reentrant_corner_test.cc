// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/reentrant_corner.h>

#include <gtest/gtest.h>

namespace hybrid::scene
{
  namespace
  {
    /// Two cells of 1 m beside each other, the upper right corner @p rise higher than the others.
    SectionMesh two_cells(const double rise)
    {
      SectionMesh mesh;
      mesh.nodes         = {{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1., 1.}, {2., 1. + rise}};
      mesh.bedrock_cells = {{{0, 1, 4, 3}}, {{1, 2, 5, 4}}};
      return mesh;
    }



    TEST(ReentrantCorner, is_none_on_a_level_surface_or_a_crest)
    {
      EXPECT_FALSE(has_reentrant_corner(two_cells(0.)));
      EXPECT_FALSE(has_reentrant_corner(two_cells(-0.5)));
    }



    TEST(ReentrantCorner, is_at_the_toe_of_a_slope_and_where_straight_edges_follow_a_curve)
    {
      EXPECT_TRUE(has_reentrant_corner(two_cells(0.5)));
      EXPECT_TRUE(has_reentrant_corner(two_cells(0.1)));    // 6 degrees
      EXPECT_FALSE(has_reentrant_corner(two_cells(0.001))); // 0.06
    }



    TEST(ReentrantCorner, is_where_a_mass_ends_on_the_bedrock)
    {
      SectionMesh mesh = two_cells(0.);
      mesh.nodes.insert(mesh.nodes.end(), {{0., 2.}, {1., 2.}, {2., 2.}});
      mesh.blocks = {{3, 4, 7, 6}};
      EXPECT_TRUE(has_reentrant_corner(mesh));
      mesh.blocks.push_back({4, 5, 8, 7}); // a column over all of it
      EXPECT_FALSE(has_reentrant_corner(mesh));
    }
  } // namespace
} // namespace hybrid::scene
