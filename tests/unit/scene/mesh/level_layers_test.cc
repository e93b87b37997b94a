// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/level_layers.h>

#include <gtest/gtest.h>

namespace hybrid::scene
{
  namespace
  {
    /// Two by two cells of 1 m of these regions, from below to the top, left to right; the middle
    /// node is @p rise higher than those beside it.
    SectionMesh four_cells(const std::vector<int> &regions, const double rise = 0.)
    {
      SectionMesh mesh;
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
          mesh.nodes.emplace_back(column, row + (row == 1 && column == 1 ? rise : 0.));
      mesh.bedrock_cells  = {{{0, 1, 4, 3}}, {{1, 2, 5, 4}}, {{3, 4, 7, 6}}, {{4, 5, 8, 7}}};
      mesh.bedrock_region = regions;
      return mesh;
    }



    TEST(LevelLayers, are_regions_above_each_other_or_one)
    {
      EXPECT_TRUE(has_level_layers(four_cells({0, 0, 0, 0})));
      EXPECT_TRUE(has_level_layers(four_cells({0, 0, 1, 1})));
      EXPECT_TRUE(has_level_layers(four_cells({0, 0, 1, 1}, 0.01))); // 0.6 degrees
    }



    TEST(LevelLayers, are_none_where_regions_lie_beside_each_other_or_their_boundary_slopes)
    {
      EXPECT_FALSE(has_level_layers(four_cells({0, 1, 0, 1})));
      EXPECT_FALSE(has_level_layers(four_cells({0, 0, 0, 1}))); // a corner
      EXPECT_FALSE(has_level_layers(four_cells({0, 0, 1, 1}, 0.1)));
      EXPECT_TRUE(has_level_layers(four_cells({0, 0, 0, 0}, 0.1))); // within one region
    }
  } // namespace
} // namespace hybrid::scene
