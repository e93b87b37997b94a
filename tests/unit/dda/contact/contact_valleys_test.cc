// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scenes.h"

#include <algorithm>
#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::dda::contact_scenes;

  TEST(ContactValleys, AVertexPressedIntoAValleyTouchesBothItsEdges)
  {
    // A floor and a steep wall, as surface and as the notch of a block. Pressed into the valley the
    // vertex is beside the end of either edge, and behind both.
    const Outline tilted{{0., 0.}, {0.97, 0.24}, {0.73, 1.21}, {-0.24, 0.97}};
    Geometry      ground = blocks({tilted}), notched = ground;
    ground.foundation_nodes = {{-1., 2.5}, {0., 0.}, {4., 0.}};
    add_block(notched, {{-2., -1.}, {4., -1.}, {4., 0.}, {0., 0.}, {-1., 2.5}, {-2., 2.5}});
    for (Geometry *g : {&ground, &notched})
      {
        const auto touched = [&](Contacts &contacts, const Vec2 &place) {
          Geometry moved = *g;
          move_block(moved, 0, place);
          ContactDetection(parameters).update(moved, contacts);
          return std::count_if(contacts.begin(), contacts.end(), [](const Contact &c) {
            return c.vertex_body == 0 && c.vertex == 0;
          });
        };
        for (const Vec2 &place : {Vec2(1e-4, -1e-3),   // on the floor, behind the wall by less
                                  Vec2(-2e-4, -1e-3),  // beside both
                                  Vec2(-2e-3, 1e-3),   // inside the wall, above the floor
                                  Vec2(-2e-3, -1e-2)}) // deep
          {
            Contacts found;
            EXPECT_EQ(touched(found, place), 2) << place.transpose();
            EXPECT_EQ(touched(found, place), 2) << "the contacts persist";
          }
        Contacts found;
        EXPECT_EQ(touched(found, {0.5, -1e-3}), 1) << "far from the wall";
      }
  }

  TEST(ContactValleys, ACornerAtTheFootOfAWallTouchesFloorAndWall)
  {
    for (const double gap : {0., 1e-5, -1e-5})
      {
        Geometry g         = blocks({square(-1. - gap, 0.)});
        g.foundation_nodes = {{-5., 0.}, {0., 0.}, {0.001, 3.}, {5., 3.}};
        ContactDetection detection(parameters);
        Contacts         contacts;
        for (int step = 0; step < 3; ++step)
          {
            detection.update(g, contacts);
            EXPECT_NE(find(contacts, 1, foundation_body, 0), nullptr) << "floor, " << gap;
            EXPECT_NE(find(contacts, 1, foundation_body, 1), nullptr) << "wall, " << gap;
            move_block(g, 0, {0., -1e-6});
          }
      }
  }

  TEST(ContactValleys, ValleyActsWithBothSides)
  {
    Geometry g         = blocks({{{0., 1e-3}, {0.1, 1.}, {-0.1, 1.}}});
    g.foundation_nodes = {{-1., 1.}, {0., 0.}, {1., 1.}};
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    EXPECT_NE(find(contacts, 0, foundation_body, 0), nullptr);
    EXPECT_NE(find(contacts, 0, foundation_body, 1), nullptr);

    g.foundation_nodes = {{-1., -0.02}, {0., 0.}, {1., -0.02}}; // a gentle ridge: one only
    contacts.clear();
    detection.update(g, contacts);
    EXPECT_EQ(count_vertex(contacts, 0), 1);
  }

  TEST(ContactValleys, ABlockOnTheUpperTreadOfALowStepIsHeldByItsTread)
  {
    // The corner is behind the riser by less than the reach: the lower tread, which goes on below
    // the riser, is not what it stands on. As surface and as the steps of a block.
    for (const double riser : {0.01, 0.06})
      for (const double from_riser : {0.01, 0.08})
        for (const double overlap : {0., 1e-6, 5e-3})
          {
            Geometry ground = blocks({square(-1. - from_riser, -overlap)}), stepped = ground;
            ground.foundation_nodes = {{-5., 0.}, {0., 0.}, {0., -riser}, {5., -riser}};
            add_block(stepped,
                      {{-5., -1.}, {5., -1.}, {5., -riser}, {0., -riser}, {0., 0.}, {-5., 0.}});
            for (Geometry *g : {&ground, &stepped})
              {
                const int upper_body = g == &ground ? foundation_body : 1;
                const int upper_edge = g == &ground ? 0 : 8; // of the block: that which ends it
                Contacts  contacts;
                ContactDetection(parameters).update(*g, contacts);
                EXPECT_NE(find(contacts, 1, upper_body, upper_edge), nullptr)
                  << "riser " << riser << ", " << from_riser << " from it, overlap " << overlap;
                EXPECT_EQ(count_vertex(contacts, 1), 1);
              }
          }
  }
} // namespace
