// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/surface_valley.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  const double root = std::sqrt(0.5);



  double valley(const Geometry &g, const int body, const int edge)
  {
    const auto next = rising_edges(g, body, edge);
    return std::max(next[0].sine, next[1].sine);
  }
} // namespace



TEST(SurfaceValley, the_foundation_rises_at_either_end_of_an_edge)
{
  Geometry g;
  g.foundation_nodes = {{0., 5.}, {2., 3.}, {4., 3.}, {6., 3.}, {6., 8.}, {9., 8.}, {10., 7.}};
  EXPECT_NEAR(valley(g, foundation_body, 0), root, 1e-15);
  EXPECT_NEAR(valley(g, foundation_body, 1), root, 1e-15);
  EXPECT_EQ(valley(g, foundation_body, 2), 1.);
  EXPECT_EQ(valley(g, foundation_body, 3), 1.);
  EXPECT_EQ(valley(g, foundation_body, 4), 0.); // a cliff before it, a fall after it
  EXPECT_EQ(valley(g, foundation_body, 5), 0.);
}



TEST(SurfaceValley, blocks_of_the_bedrock_have_the_rock_on_the_other_side)
{
  // The edge of block 0 from (2, 0) to (0, 2) falls to (2, 0), where that of block 1 from (4, 1)
  // to (2, 0) rises.
  Geometry g;
  g.offset          = {0, 3, 6};
  g.block_of        = {0, 0, 0, 1, 1, 1};
  g.vertices        = {{0., 0.}, {2., 0.}, {0., 2.}, {2., 0.}, {4., 0.}, {4., 1.}};
  g.bedrock         = {0, {-2, -1, -2, -2, -2, 1}, {-2, 5, -2, -2, -2, -1}};
  const double sine = std::sin(M_PI / 4. + std::atan(0.5));
  EXPECT_NEAR(valley(g, 0, 1), sine, 1e-15);
  EXPECT_NEAR(valley(g, 1, 5), sine, 1e-15);
}
