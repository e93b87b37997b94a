// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/downhill.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;

  double sign_of(const std::vector<Vec2> &nodes, const std::string &line = "sliding_surface")
  {
    scene::SectionMesh mesh;
    mesh.nodes = nodes;
    for (int k = 0; k + 1 < static_cast<int>(nodes.size()); ++k)
      mesh.lines[line].push_back({k, k + 1});
    return scene::downhill_sign(mesh);
  }
} // namespace



TEST(Downhill, points_to_the_lower_end_of_the_sliding_surface)
{
  EXPECT_EQ(sign_of({{0., 0.}, {10., 5.}}), -1.);
  EXPECT_EQ(sign_of({{0., 5.}, {10., 0.}}), 1.);
  EXPECT_EQ(sign_of({{10., 0.}, {0., 5.}}), 1.);
  EXPECT_EQ(sign_of({{0., 4.}, {4., -2.}, {10., 1.}}), 1.);            // rises at the toe
  EXPECT_EQ(sign_of({{0., 0.}, {10., 3.}, {10., 8.}}), -1.);           // scarp
  EXPECT_EQ(sign_of({{0., 9.}, {0., 0.}, {10., 3.}, {10., 4.}}), -1.); // between walls
}



TEST(Downhill, a_level_surface_or_none_has_no_downhill)
{
  EXPECT_EQ(sign_of({{0., 1.}, {10., 1. + 1e-7}}), 0.);
  EXPECT_EQ(sign_of({{0., 5.}, {0., 0.}, {10., 0.}, {10., 5.}}), 0.);
  EXPECT_EQ(scene::downhill_sign({}), 0.);
}



TEST(Downhill, a_slope_on_level_ground_falls_as_its_surface_does)
{
  scene::SectionMesh mesh;
  mesh.nodes                    = {{0., 0.}, {40., 0.}, {40., 10.}, {20., 10.}};
  mesh.lines["sliding_surface"] = {{0, 1}};
  EXPECT_EQ(scene::downhill_sign(mesh), 0.);
  mesh.lines["mass_surface"] = {{1, 2}, {2, 3}, {3, 0}}; // with a wall at the right
  EXPECT_EQ(scene::downhill_sign(mesh), -1.);
  mesh.nodes[3] = {0., 10.};
  EXPECT_EQ(scene::downhill_sign(mesh), 0.); // a block
}



TEST(Downhill, blocks_on_the_ground_slide_towards_its_lower_end)
{
  EXPECT_EQ(sign_of({{0., 0.}, {10., 5.}}, "ground"), -1.);
  EXPECT_EQ(sign_of({{0., 5.}, {10., 0.}}, "ground"), 1.);
}



TEST(Downhill, of_a_level_stretch_is_that_of_the_surface_beside_it)
{
  const auto beside = [](const double left, const double right) {
    scene::SectionMesh mesh;
    mesh.nodes                    = {{-9., left}, {0., 0.}, {2., 0.}, {9., right}};
    mesh.lines["sliding_surface"] = {{0, 1}, {1, 2}, {2, 3}};
    return scene::downhill_beside({{0., 0.}, {2., 0.}}, mesh);
  };
  EXPECT_EQ(beside(3., 0.), 1.);
  EXPECT_EQ(beside(3., -1.), 1.);
  EXPECT_EQ(beside(-3., 0.), -1.);
  EXPECT_EQ(beside(3., 4.), 0.);   // valley
  EXPECT_EQ(beside(-3., -4.), 0.); // hill
}
