// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/overlap_watch.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;

  /// A square of 2 m that is so deep in level ground [m].
  dda::Geometry sunk(const double depth)
  {
    dda::Geometry g;
    g.offset           = {0, 4};
    g.block_of         = {0, 0, 0, 0};
    g.vertices         = {{0., -depth}, {2., -depth}, {2., 2. - depth}, {0., 2. - depth}};
    g.foundation_nodes = {{-5., 0.}, {5., 0.}};
    return g;
  }
} // namespace



TEST(OverlapWatch, warns_once_and_keeps_the_deepest)
{
  output::OverlapWatch watch;
  watch.look(sunk(0.01), 1.);
  EXPECT_EQ(watch.warning(), "");
  watch.look(sunk(0.2), 2.);
  const std::string text = watch.warning();
  EXPECT_NE(
    text.find(
      "at t = 2 s a block of 2 m at (0.00, -0.20) is in the ground by 0.2 m, 10 % of its size"),
    std::string::npos)
    << text;
  watch.look(sunk(0.4), 3.);
  EXPECT_EQ(watch.warning(), "");
  watch.look(sunk(0.1), 4.);
  EXPECT_NEAR(watch.deepest().part, 0.2, 1e-12);
  EXPECT_EQ(watch.time_of_deepest(), 3.);
}
