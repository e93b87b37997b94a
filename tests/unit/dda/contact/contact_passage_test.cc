// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_passage.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  constexpr double reach = 0.1, depth = 0.05;

  /// A unit square with its lower left corner at the origin (block 0), a point of another block
  /// (block 1, a triangle), and a level foundation at y = 0 with its rock below.
  struct Places
  {
    Geometry                 geometry;
    std::vector<BlockMotion> blocks;
    std::vector<Vec2>        vertices, nodes;

    explicit Places(const Vec2 &point)
    {
      geometry.vertices         = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};
      geometry.offset           = {0, 4, 7};
      geometry.block_of         = {0, 0, 0, 0, 1, 1, 1};
      geometry.foundation_nodes = {{-10., 0.}, {0., 0.}, {10., 0.}};
      for (const Vec2 &corner : {Vec2(0., 0.), Vec2(1., 1.), Vec2(-1., 1.)})
        geometry.vertices.push_back(point + corner);
      for (int b = 0; b < 2; ++b)
        blocks.emplace_back(Vec2(0.5, 0.5), Vec6::Zero());
      vertices.assign(geometry.vertices.size(), Vec2::Zero());
      nodes.assign(geometry.foundation_nodes.size(), Vec2::Zero());
    }

    /// The point of block 1 moves by @p way: whether that takes it into block 0.
    bool into_block(const Vec2 &way)
    {
      vertices[4] = way;
      return passage().takes({1, 4, 0, -1});
    }

    bool behind_edge(const int edge, const Vec2 &way)
    {
      vertices[4] = way;
      return passage().takes({1, 4, foundation_body, edge});
    }

    ContactPassage passage() const
    {
      return {geometry, motion, pairs};
    }

    StepMotion     motion{blocks, vertices, nodes};
    PairTolerances pairs{{reach, depth, depth}};
  };
} // namespace



TEST(ContactPassage, into_a_block_or_through_it)
{
  Places above({0.5, 1.2});
  EXPECT_FALSE(above.into_block({0., 0.}));
  EXPECT_FALSE(above.into_block({0., -0.1}));  // not there yet
  EXPECT_FALSE(above.into_block({0., -0.24})); // no deeper than counts
  EXPECT_TRUE(above.into_block({0., -0.3}));
  EXPECT_TRUE(above.into_block({0., -3.}));
  EXPECT_FALSE(above.into_block({3., 0.}));
  EXPECT_FALSE(above.into_block({0., 3.}));
}



TEST(ContactPassage, over_a_corner_or_along_a_face_is_none)
{
  Places corner({-0.2, 0.85});
  EXPECT_FALSE(corner.into_block({0.37, 0.37})); // cuts the corner off by 0.02
  EXPECT_TRUE(corner.into_block({0.6, 0.}));
  Places pressed({-0.2, 0.99}); // slides over the top, pressed by 0.01
  EXPECT_FALSE(pressed.into_block({2., 0.}));
  EXPECT_FALSE(pressed.into_block({0.7, 0.}));
  EXPECT_FALSE(Places({0.5, 0.5}).into_block({0.2, 0.})); // was inside
  Places tip({-0.25, 1.25});                              // through the corner (0, 1) itself
  EXPECT_TRUE(tip.into_block({0.75, -0.75}));
  EXPECT_TRUE(tip.into_block({2., -2.}));
  EXPECT_FALSE(tip.into_block({0.25, -0.25}));
  EXPECT_FALSE(tip.into_block({0.5, 0.})); // beside it
}



TEST(ContactPassage, what_counts_is_the_way_seen_from_the_body)
{
  Places rising({0.5, 1.2});
  rising.blocks[0] = BlockMotion(Vec2(0.5, 0.5), (Vec6() << 0., 0.3, 0., 0., 0., 0.).finished());
  EXPECT_TRUE(rising.into_block({0., 0.}));
  EXPECT_FALSE(rising.into_block({0., 0.3}));
}



TEST(ContactPassage, behind_an_edge_of_a_surface)
{
  Places above({3., 0.2});
  EXPECT_FALSE(above.behind_edge(1, {0., -0.24}));
  EXPECT_TRUE(above.behind_edge(1, {0., -0.3}));
  EXPECT_TRUE(above.behind_edge(1, {0., -30.}));
  EXPECT_FALSE(above.behind_edge(0, {0., -0.3})); // through the other one
  EXPECT_TRUE(above.behind_edge(0, {-6., -0.4}));
  EXPECT_FALSE(above.behind_edge(1, {0., 0.3}));
  EXPECT_FALSE(Places({3., -0.2}).behind_edge(1, {0., 0.5})); // from below
  above.nodes = {Vec2(0., 0.3), Vec2(0., 0.3), Vec2(0., 0.3)};
  EXPECT_TRUE(above.behind_edge(1, {0., 0.}));
}
