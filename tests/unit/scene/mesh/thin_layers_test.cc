// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/thin_layers.h>

#include <gtest/gtest.h>

namespace hybrid::scene
{
  namespace
  {
    /// A layer of 20 m over one of 80 m, both 160 m wide, in cells as large as @p size at most.
    SectionMesh two_layers(const double size)
    {
      SectionMesh mesh;
      int         surface = 0;
      for (const auto &[bottom, height] : {std::pair(0., 80.), std::pair(80., 20.)})
        {
          ++surface;
          const int    rows = std::max(1, static_cast<int>(height / size));
          const double dy   = height / rows;
          for (double x = 0.; x < 160.; x += size)
            for (int row = 0; row < rows; ++row)
              {
                const int    n = static_cast<int>(mesh.nodes.size());
                const double y = bottom + row * dy;
                for (const Vec2 &p :
                     {Vec2(x, y), Vec2(x + size, y), Vec2(x + size, y + dy), Vec2(x, y + dy)})
                  mesh.nodes.push_back(p);
                mesh.bedrock_cells.push_back({n, n + 1, n + 2, n + 3});
                mesh.bedrock_surface.push_back(surface);
              }
        }
      return mesh;
    }
  } // namespace


  TEST(ThinLayers, CellsAreAsThickAsTheirAreaOverTheirWidth)
  {
    const auto thickness = cell_thickness(two_layers(40.));
    EXPECT_NEAR(thickness.at(1), 40., 1e-12);
    EXPECT_NEAR(thickness.at(2), 20., 1e-12);
    SectionMesh drawn = two_layers(40.);
    drawn.bedrock_surface.clear();
    EXPECT_TRUE(cell_thickness(drawn).empty());
  }


  TEST(ThinLayers, ALayerOneCellThickIsKeptByCoarserMeshes)
  {
    const auto fine = cell_thickness(two_layers(10.)), middle = cell_thickness(two_layers(20.)),
               coarse = cell_thickness(two_layers(40.));
    EXPECT_FALSE(keeps_thin_layers(fine, middle));
    EXPECT_TRUE(keeps_thin_layers(middle, coarse));
    EXPECT_FALSE(keeps_thin_layers({}, coarse));
    EXPECT_FALSE(keeps_thin_layers({{1, 20.}}, {{1, 20.}})); // nothing is thicker
  }
} // namespace hybrid::scene
