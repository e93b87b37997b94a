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
} // namespace
