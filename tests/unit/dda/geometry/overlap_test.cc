// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/overlap.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using Outline = std::vector<Vec2>;

  Geometry blocks(const std::vector<Outline> &outlines)
  {
    Geometry g;
    g.offset.push_back(0);
    for (const Outline &outline : outlines)
      {
        for (const Vec2 &p : outline)
          {
            g.vertices.push_back(p);
            g.block_of.push_back(static_cast<int>(g.offset.size()) - 1);
          }
        g.offset.push_back(static_cast<int>(g.vertices.size()));
      }
    return g;
  }

  Outline square(const double x, const double y, const double size)
  {
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  }

  TEST(Overlap, BlocksThatTouchDoNotOverlap)
  {
    Geometry g          = blocks({square(0., 0., 1.), square(1., 0., 1.), square(0.3, 1., 1.)});
    g.foundation_nodes  = {{-5., 0.}, {5., 0.}};
    const Overlap found = deepest_overlap(g);
    EXPECT_EQ(found.block, -1);
    EXPECT_EQ(found.depth, 0.);
  }

  TEST(Overlap, IsThatOfTheDeepestCornerAsAPartOfTheSmallerBlock)
  {
    const Overlap found =
      deepest_overlap(blocks({square(0., 0., 10.), square(9.9, 4., 1.), square(9.5, 8., 8.)}));
    EXPECT_EQ(found.block, 1); // 10 % of 1 m, not 6 % of 8 m
    EXPECT_EQ(found.other, 0);
    EXPECT_NEAR(found.part, 0.1, 1e-12);
    EXPECT_NEAR(found.depth, 0.1, 1e-12);
    EXPECT_NEAR(found.size, 1., 1e-12);
    EXPECT_NEAR(found.place.x(), 9.9, 1e-12);
  }

  TEST(Overlap, OfABlockInItsEqualIsSeenAtItsMiddle)
  {
    EXPECT_NEAR(deepest_overlap(blocks({square(0., 0., 2.), square(0., 0., 2.)})).part, 0.5, 1e-12);
  }

  TEST(Overlap, ABlockInTheNotchOfAnotherOneTouchesIt)
  {
    const Outline u{{0., 0.}, {5., 0.}, {5., 4.}, {4., 4.}, {4., 1.}, {1., 1.}, {1., 4.}, {0., 4.}};
    EXPECT_EQ(deepest_overlap(blocks({u, square(1., 1., 3.)})).block, -1);
    EXPECT_NEAR(deepest_overlap(blocks({u, square(0.9, 1., 3.)})).depth, 0.1, 1e-12);
  }

  TEST(Overlap, WithTheGroundIsSeenBelowAnOverhangAndAtARidge)
  {
    Geometry g = blocks({square(0.5, -0.2, 1.)});
    // a cliff with an overhang over the block: what is below the roof is in the air
    g.foundation_nodes = {{-5., 3.}, {3., 3.}, {0., 2.}, {0., 0.}, {5., 0.}};
    Overlap found      = deepest_overlap(g);
    EXPECT_EQ(found.other, foundation_body);
    EXPECT_NEAR(found.depth, 0.2, 1e-12);

    g.foundation_nodes = {{-5., -1.}, {1., 0.1}, {5., -1.}}; // a ridge in the sole
    found              = deepest_overlap(g);
    EXPECT_EQ(found.block, 0);
    EXPECT_EQ(found.other, foundation_body);
    EXPECT_NEAR(found.depth, 0.3, 1e-12);
    EXPECT_NEAR(found.place.y(), 0.1, 1e-12);

    g.foundation_nodes = {{-5., -1.}, {0., -1.}}; // the block is beyond its end
    EXPECT_EQ(deepest_overlap(g).block, -1);
  }

  TEST(Overlap, WhatHasFallenBesideTheEndOfTheGroundIsNotInIt)
  {
    const auto below = [](const double x, const double y) {
      Geometry g         = blocks({square(x, y, 1.)});
      g.foundation_nodes = {{-20., 0.}, {0., 0.}};
      return deepest_overlap(g).depth;
    };
    EXPECT_EQ(below(-1.5, -9.), 0.) << "drifts under the end";
    EXPECT_NEAR(below(-1.5, -0.1), 0.1, 1e-12) << "in the ground near the end";
    EXPECT_NEAR(below(-10., -3.), 3., 1e-12) << "in the ground";
  }

  TEST(Overlap, OfBedrockBlocksWithEachOtherIsNotLookedAt)
  {
    Geometry g            = blocks({square(0., 1.9, 1.), square(0., 0., 2.), square(1., 0., 2.)});
    g.bedrock.first_block = 1;
    const Overlap found   = deepest_overlap(g);
    EXPECT_EQ(found.block, 0);
    EXPECT_NEAR(found.depth, 0.1, 1e-12);
  }
} // namespace
