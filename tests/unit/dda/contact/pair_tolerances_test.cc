// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scenes.h"

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::dda::contact_scenes;

  constexpr double infinite = std::numeric_limits<double>::infinity();

  TEST(PairTolerances, AreThoseOfTheSmallerBody)
  {
    PairTolerances pairs(ContactTolerances{0.1, 0.5, 0.5});
    pairs.set_sizes({2., 0.2, 1., infinite});
    EXPECT_EQ(pairs.of(0, foundation_body).reach, 0.1);
    EXPECT_EQ(pairs.of(0, foundation_body).max_depth, 0.5);
    EXPECT_EQ(pairs.of(0, 2).max_depth, 0.25);
    EXPECT_EQ(pairs.of(0, 2).reach, 0.1) << "none reaches farther than all";
    EXPECT_EQ(pairs.of(3, 1).reach, 0.05);
    EXPECT_EQ(pairs.of(1, 0).max_depth, 0.05);
    EXPECT_EQ(pairs.narrowest().reach, 0.05);
    EXPECT_EQ(pairs.of(foundation_body).max_depth, 0.5);
    EXPECT_EQ(pairs.of(1, 0).held_depth, 0.5) << "what presses is not lost for its size";
  }

  /// A slab on a row of bricks with cracks between them, every second one a little lower.
  Geometry slab_on_row(const double x, const double crack)
  {
    Geometry g = blocks({{{x, 0.}, {x + 3., 0.}, {x + 3., 1.}, {x, 1.}}});
    for (int i = 0; i < 6; ++i)
      {
        const double left = i * (2. + crack), top = i % 2 == 0 ? 0. : -2e-5;
        add_block(g, {{left, -1.}, {left + 2., -1.}, {left + 2., top}, {left, top}});
      }
    return g;
  }

  /// The slab slides along; @return its corners' contacts with sides of bricks, at most.
  int sides_met(const double crack, const bool has_pebble)
  {
    constexpr double    pebble = 1e-3, step = 2.5e-3;
    Geometry            g = slab_on_row(0.5, crack);
    std::vector<double> sizes(7, 1.5);
    if (has_pebble)
      {
        add_block(g, square(90., 0., pebble));
        sizes.push_back(pebble);
      }
    ContactDetection detection({0.15, 0.5, 1e-3, 0.4, 0.4});
    detection.set_sizes(sizes);
    Contacts contacts;
    int      most = 0;
    for (int k = 0; k < 1200; ++k)
      {
        detection.update(g, contacts);
        int sides = 0;
        for (const Contact &c : contacts)
          sides += c.vertex_body == 0 && c.vertex < 2 && (c.edge - g.offset[c.edge_body]) % 2 == 1;
        most = std::max(most, sides);
        move_block(g, 0, {step, k == 0 ? -1e-5 : 0.}); // pressed
      }
    return most;
  }

  TEST(PairTolerances, APebbleElsewhereDoesNotMakeSeamsCatch)
  {
    for (const double crack : {0., 1e-4, 1e-3, 0.01, 0.1})
      {
        EXPECT_EQ(sides_met(crack, false), 0) << crack;
        EXPECT_EQ(sides_met(crack, true), 0) << crack << " with a pebble of 1 mm";
      }
  }
} // namespace
