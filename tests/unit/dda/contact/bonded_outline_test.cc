// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scenes.h"

namespace hybrid::dda
{
  namespace
  {
    using namespace contact_scenes;

    constexpr double step = 0.002;

    /// Two triangles with their base on y = 1 and one between them that touches y = 1 with its tip
    /// alone; the right one stands a little higher. A square lies on the left one.
    Geometry row()
    {
      return blocks({{{1., 1.}, {0., 1.}, {0.5, 0.}},
                     {{1., 1.}, {0.5, 0.}, {1.5, 0.}},
                     {{2., 1. + step}, {1., 1. + step}, {1.5, step}},
                     {{0.2, 1.}, {0.9, 1.}, {0.9, 2.}, {0.2, 2.}}});
    }

    /// All three of the row are bonded.
    BondedOutline bonded(const Geometry &g)
    {
      BondedOutline outline(g);
      outline.bond(g, 2, 3);
      outline.bond(g, 5, 7);
      return outline;
    }


    TEST(BondedOutline, CoversEdgesAndCornersBetweenBonds)
    {
      const Geometry      g       = row();
      const BondedOutline outline = bonded(g);
      for (const int edge : {2, 3, 5, 7})
        EXPECT_TRUE(outline.covers(edge)) << edge;
      for (const int edge : {0, 1, 4, 6, 8})
        EXPECT_FALSE(outline.covers(edge)) << edge;
      EXPECT_TRUE(outline.covers_corner(g, 3)) << "the tip between its neighbours";
      for (const int corner : {0, 1, 2, 4, 5, 6, 7, 8})
        EXPECT_FALSE(outline.covers_corner(g, corner)) << corner;
      EXPECT_FALSE(BondedOutline().covers(0));
      EXPECT_FALSE(outline == BondedOutline(g));
    }


    TEST(BondedOutline, KnowsTheNodeAndTheStepOfBondedEnds)
    {
      const Geometry      g       = row();
      const BondedOutline outline = bonded(g);
      EXPECT_EQ(outline.node_of(0), outline.node_of(3));
      EXPECT_EQ(outline.node_of(0), outline.node_of(7)) << "by the tip between them";
      EXPECT_NE(outline.node_of(0), outline.node_of(4));
      const Vec2 up(0., 1.);
      EXPECT_NEAR(outline.step(g, 0, 6, up), step, 1e-12);
      EXPECT_NEAR(outline.step(g, 6, 0, up), step, 1e-12);
      EXPECT_EQ(outline.step(g, 0, 8, up), 0.) << "they do not meet";
      EXPECT_EQ(BondedOutline().step(g, 0, 6, up), 0.);
    }


    TEST(BondedOutline, NothingTouchesTheSidesBelowARow)
    {
      Geometry g = row();
      for (const bool is_bonded : {false, true})
        {
          ContactDetection detection(parameters);
          SkippedPairs     skipped;
          if (is_bonded)
            skipped.outline = bonded(g);
          skipped.bonded = {{0, 1}, {1, 2}};
          detection.set_skipped_pairs(skipped);
          Contacts contacts;
          move_block(g, 3, Vec2(0.09, -step)); // its corner is as deep as the step is high
          detection.update(g, contacts);
          move_block(g, 3, Vec2(-0.09, step));
          EXPECT_NE(find(contacts, 10, 0, 0), nullptr) << "the sole's corner on the left triangle";
          for (const Contact &c : contacts)
            if (is_bonded)
              {
                EXPECT_NE(c.vertex, 3) << "the tip";
                EXPECT_FALSE(c.edge == 3 || c.edge == 7) << "side of block " << c.edge_body;
              }
        }
    }
  } // namespace
} // namespace hybrid::dda
