// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scenes.h"

#include <hybrid/dda/springs/contact_load.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::dda::contact_scenes;

  // ------------------------------------------------------------- mesh of squares

  TEST(ContactSelection, CoincidentCornersOfAStackTouchTheirNeighboursOnly)
  {
    const int columns = 10, rows = 5;
    Geometry  g;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        add_block(g, square(i, j));
    for (int i = -1; i <= columns + 1; ++i)
      g.foundation_nodes.emplace_back(i, 0.);

    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    for (const Contact &c : contacts)
      {
        if (c.vertex_body == foundation_body)
          {
            EXPECT_LT(c.edge_body, columns) << "places of the base touch the lowest row";
            EXPECT_EQ(c.edge % 4, 0) << "at its soles";
            continue;
          }
        if (c.edge_body == foundation_body)
          continue;
        const int d = std::abs(c.vertex_body - c.edge_body);
        EXPECT_TRUE(d == 1 || d == columns)
          << c.vertex_body << " touches " << c.edge_body << " over the corner";
        EXPECT_TRUE(c.edge_position < 1e-12 || c.edge_position > 1. - 1e-12);
      }
    // every shared edge: two vertices each way; every bottom corner once on the foundation, every
    // place of the foundation below the row once on a sole
    const int shared = (columns - 1) * rows + columns * (rows - 1);
    EXPECT_EQ(contacts.size(), static_cast<std::size_t>(4 * shared + 2 * columns + columns + 1));
  }

  TEST(ContactSelection, TipsThatHavePassedEachOtherTouchWithoutForce)
  {
    // Two tips slide towards each other on flat ground, both below the lower edge of the other
    // block, so that neither is ever inside it.
    const auto scene = [](const double passed) {
      Geometry g =
        blocks({{{0., 0.}, {0.6, 0.16}, {0.3, 0.4}}, {{0., 0.}, {-0.2, 0.6}, {-0.35, 0.26}}});
      g.foundation_nodes = {{-5., 0.}, {5., 0.}};
      move_block(g, 1, {passed, 0.});
      return g;
    };
    constexpr double passed = 1e-3;
    const double     steep = 0.6 / std::hypot(0.2, 0.6), flat = 0.4 / std::hypot(0.3, 0.4);
    const auto       between = [](const Contacts &contacts) {
      Contacts found;
      std::copy_if(contacts.begin(),
                   contacts.end(),
                   std::back_inserter(found),
                   [](const Contact &c) {
                     return c.vertex_body != foundation_body && c.edge_body != foundation_body;
                   });
      return found;
    };
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(scene(-passed), contacts);
    EXPECT_TRUE(between(contacts).empty());

    detection.update(scene(passed), contacts);
    ContactLoads().carry(
      {}, scene(passed), [](const Contact &) { return 1.; }, contacts);
    const Contacts touching = between(contacts);
    ASSERT_EQ(touching.size(), 1u);
    EXPECT_NEAR(touching[0].stress_free_gap, -passed * std::min(steep, flat), 1e-12)
      << "the way out is the shorter one";

    detection.update(scene(1.5 * passed), contacts);
    ASSERT_EQ(between(contacts).size(), 1u);
    EXPECT_EQ(between(contacts)[0].edge, touching[0].edge) << "the contact persists";

    // The same tips, one high enough to pass over the other: an open contact.
    contacts.clear();
    Geometry above = scene(passed);
    move_block(above, 1, {0., 5e-3});
    detection.update(above, contacts);
    for (const Contact &c : between(contacts))
      EXPECT_EQ(c.stress_free_gap, 0.);
  }

  TEST(ContactSelection, ASoleThatSlidesOffATipIsSeenByTheTip)
  {
    // The tip of the lower block bears the sole of the upper one, which is pressed 4 mm into it.
    // The upper corner leaves the lower edge; the lower corner is not in the upper block before
    // that has slid on by 4 mm. Meanwhile the two sides that lie on each other do not cross.
    const auto scene = [](const double slid) {
      Geometry g =
        blocks({{{0., 0.}, {0.9, -0.6}, {1.4, 0.}}, {{0.02, 0.}, {1.4, 0.}, {0.9, 0.6}}});
      move_block(g, 1, {slid, -4e-3});
      return g;
    };
    const auto bears = [](const Contacts &contacts) {
      return std::count_if(contacts.begin(), contacts.end(), [](const Contact &c) {
        return (c.vertex == 2 && c.edge == 3) || (c.vertex == 4 && c.edge == 2);
      });
    };
    ContactDetection detection(parameters);
    Contacts         contacts;
    for (const double slid : {-1e-3, 1e-4, 1e-3, 2e-3, 3e-3, 5e-3})
      {
        detection.update(scene(slid), contacts);
        EXPECT_GE(bears(contacts), 1) << slid;
      }
  }

  TEST(ContactSelection, CornerThatComesDownOnATipKeepsTipAndGround)
  {
    // The halves of a flat rectangle, 1 mm apart, fall on the ground: the tip of the lower one
    // comes to lie between the corner of the upper one and the ground, within 10 degrees of both.
    const double height = 2. * std::tan(M_PI / 180.), above = 0.01;
    Geometry     g =
      blocks({{{0., above}, {2., above}, {2., above + height}},
              {{2., above + height + 1e-3}, {0., above + height + 1e-3}, {0., above + 1e-3}}});
    g.foundation_nodes = {{-5., 0.}, {5., 0.}};
    ContactDetection detection(parameters);
    Contacts         contacts;
    const int        corner = 5, upper_side = 2;
    const auto       has = [&](const int body, const int edge) {
      return std::any_of(contacts.begin(), contacts.end(), [&](const Contact &c) {
        return c.vertex_body == 1 && c.vertex == corner && c.edge_body == body && c.edge == edge;
      });
    };
    detection.update(g, contacts);
    EXPECT_TRUE(has(0, upper_side) && has(foundation_body, 0));
    move_block(g, 0, {0., -above - 1e-7});
    move_block(g, 1, {0., -above - 1e-3 - 3e-7});
    detection.update(g, contacts);
    EXPECT_TRUE(has(0, upper_side)) << "else the tip rises through the corner";
    EXPECT_TRUE(has(foundation_body, 0));
  }

  TEST(ContactSelection, RowOfEqualHeightCarriesASlidingSquareWithoutSeam)
  {
    // three squares side by side, one pressed 1 um into them, sliding right
    const double depth = 1e-6;
    Geometry g = blocks({square(0., 0.), square(1., 0.), square(2., 0.), square(0.2, 1. - depth)});
    move_block(g, 1, {1e-7, 2e-7}); // as loads have left them: never exactly level
    move_block(g, 2, {-1e-7, -2e-7});
    ContactDetection detection(parameters);
    Contacts         contacts;
    const int        right = 13; // lower right vertex of the slider
    double           slip  = 0.;
    for (int step = 0; step < 2000; ++step)
      {
        detection.update(g, contacts);
        const Contact *carrying = nullptr;
        int            support  = 0;
        for (Contact &c : contacts)
          {
            if (c.vertex_body != 3 && c.edge_body != 3)
              continue;
            if (c.edge_body < 3 && c.vertex_body == 3)
              {
                EXPECT_EQ(c.edge % 4, 2)
                  << "vertex " << c.vertex << " caught by edge " << c.edge << " at step " << step;
                if (c.vertex == right)
                  carrying = &c, ++support;
              }
            if (c.edge_body == 3)
              {
                EXPECT_EQ(c.edge, 12)
                  << "a corner of the row catches the slider's side at step " << step;
              }
          }
        if (g.vertices[right].x() > 3.)
          break;
        ASSERT_EQ(support, 1) << "step " << step << " x " << g.vertices[right].x();
        // a top edge runs from right to left
        EXPECT_NEAR(carrying->slip, -slip, 1e-6);
        EXPECT_NEAR(carrying->plastic_slip, -0.9 * slip, 1e-6);
        slip += 1e-3;
        move_block(g, 3, {1e-3, 0.});
        for (Contact &c : contacts)
          if (c.vertex == right && c.vertex_body == 3)
            {
              const Edge   e = edge_of(g, c.edge_body, c.edge);
              const double t = (g.vertices[right] - e.a).dot(e.d) / e.length;
              c.slip += (t - c.edge_position) * e.length;
              c.plastic_slip  = 0.9 * c.slip;
              c.edge_position = t;
              c.state         = ContactState::sliding;
            }
      }
    EXPECT_GT(slip, 1.75);
  }

  TEST(ContactSelection, ACornerThatBeginsBeforeASeamIsNotBesideTheNextBlock)
  {
    for (const double before : {0.1, 0.05, 0.01, 1e-3, 1e-5})
      {
        Geometry         g = blocks({square(0., -1.), square(1., -1.), square(-before, 0.)});
        ContactDetection detection(parameters);
        Contacts         contacts;
        for (int step = 0; step < 20; ++step)
          {
            detection.update(g, contacts);
            EXPECT_EQ(find(contacts, 9, 1, 7), nullptr) << "corner at the side, " << before;
            EXPECT_EQ(find(contacts, 7, 2, 9), nullptr) << "side at the corner, " << before;
            EXPECT_EQ(count_vertex(contacts, 9), 1) << before;
            move_block(g, 2, {0.01, step == 0 ? -1e-4 : 0.});
          }
      }
  }

  TEST(ContactSelection, ACornerOverACrackPassesTheNextBlock)
  {
    for (const double crack : {1e-3, 0.01, 0.05})
      for (const double part : {0.1, 0.5, 0.9}) // of the crack, where the corner begins
        {
          Geometry g =
            blocks({square(-1., -1.), square(crack, -1.), square(crack * part - 1., 0.)});
          ContactDetection detection(parameters);
          Contacts         contacts;
          for (int step = 0; step < 30; ++step)
            {
              detection.update(g, contacts);
              EXPECT_EQ(find(contacts, 9, 1, 7), nullptr) << "corner at the side, " << crack;
              EXPECT_EQ(find(contacts, 7, 2, 9), nullptr) << "side at the corner, " << crack;
              move_block(g, 2, {0.01, step == 0 ? -1e-5 : 0.});
            }
          EXPECT_NE(find(contacts, 9, 1, 6), nullptr) << "on top";
        }
  }

  TEST(ContactSelection, StepOfTheRowIsAnObstacle)
  {
    // the next square is 5 cm higher: its side stops the slider
    Geometry         g = blocks({square(0., 0.), square(1., 0.05), square(-1e-3, 1. - 1e-6)});
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    move_block(g, 2, {2e-3, 0.});
    detection.update(g, contacts);
    EXPECT_NE(find(contacts, 9, 1, 7), nullptr)
      << "slider's corner on the left side of the higher square";
    EXPECT_EQ(find(contacts, 9, 1, 6), nullptr);
  }

  // ------------------------------------------------------------- corner against corner

  TEST(ContactSelection, DiagonalSquaresAreUndecidedUntilTheyMove)
  {
    for (const Vec2 &motion : {Vec2(1e-3, -1e-5), Vec2(1e-5, -1e-3)})
      {
        Geometry g = blocks({square(0., 0.), square(-1., 1.)}); // they share the point (0, 1)
        ContactDetection detection(parameters);
        Contacts         contacts;
        detection.update(g, contacts);
        EXPECT_TRUE(contacts.empty());

        move_block(g, 1, motion);
        detection.update(g, contacts);
        const bool over = motion.x() > 1e-4; // came in from above, or down the side
        EXPECT_NE(find(contacts, 5, 0, over ? 2 : 3), nullptr);
        EXPECT_NE(find(contacts, 3, 1, over ? 4 : 5), nullptr);
        EXPECT_EQ(contacts.size(), 2u);
      }
  }

  TEST(ContactSelection, DiagonalSquaresPassFreely)
  {
    for (const Vec2 &motion : {Vec2(-1e-4, -1e-3), Vec2(1e-3, 1e-4)})
      {
        Geometry         g = blocks({square(0., 0.), square(-1., 1.)});
        ContactDetection detection(parameters);
        Contacts         contacts;
        for (int step = 0; step < 50; ++step)
          {
            move_block(g, 1, motion);
            detection.update(g, contacts);
            for (const Contact &c : contacts)
              {
                const Edge   e   = edge_of(g, c.edge_body, c.edge);
                const double gap = (g.vertices[c.vertex] - e.a).dot(e.n);
                EXPECT_GE(gap, 0.) << "no contact pushes at step " << step;
              }
          }
      }
  }

  TEST(ContactSelection, TipOnTipActsThroughOneEdge)
  {
    // 30 degree wedges, one standing, one hanging, tips overlapping by 2 mm and 0.1 mm off centre
    const double w = std::tan(15. * degree);
    for (const double off : {1e-4, -1e-4})
      {
        Geometry g = blocks(
          {{{-w, -1.}, {w, -1.}, {0., 0.}}, {{off, -2e-3}, {w + off, 0.998}, {-w + off, 0.998}}});
        ContactDetection detection(parameters);
        Contacts         contacts;
        detection.update(g, contacts);
        ASSERT_FALSE(contacts.empty());
        for (const Contact &c : contacts)
          {
            // every contact pushes the hanging wedge to the side to which it is off
            const Vec2 n = edge_of(g, c.edge_body, c.edge).n * (c.edge_body == 0 ? 1. : -1.);
            EXPECT_GT(n.x() * off, 0.);
          }
      }
  }

  TEST(ContactSelection, CollinearEdgesTouchBothWays)
  {
    Geometry         g = blocks({square(0., 0.), square(0.4, 1.)});
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_NEAR(find(contacts, 2, 1, 4)->edge_position,
                0.6,
                1e-12); // corner of the lower on the upper's bottom
    EXPECT_NEAR(find(contacts, 4, 0, 2)->edge_position,
                0.6,
                1e-12); // corner of the upper on the lower's top
  }

  TEST(ContactSelection, HistoryDecidesThroughWhichEdgeAVertexCame)
  {
    // a narrow wedge deep in a square, nearer to the side than to the top
    const auto wedge = [](const double x, const double y) {
      return Outline{{x, y}, {x + 0.3, y + 0.4}, {x + 0.2, y + 0.5}};
    };
    Geometry         g = blocks({square(0., 0.), wedge(0.99, 1.001)});
    ContactDetection detection(parameters);
    Contacts         contacts, fresh;
    detection.update(g, contacts);
    ASSERT_NE(find(contacts, 4, 0, 2), nullptr);
    move_block(g, 1, {0., -0.021});
    detection.update(g, contacts);
    EXPECT_NE(find(contacts, 4, 0, 2), nullptr) << "came through the top";
    EXPECT_EQ(count_vertex(contacts, 4), 1);
    detection.update(g, fresh);
    EXPECT_NE(find(fresh, 4, 0, 1), nullptr) << "without history: least penetration";
    EXPECT_EQ(count_vertex(fresh, 4), 1);
  }

  // ------------------------------------------------------------- foundation

  TEST(ContactSelection, SlipIsContinuousAlongAFacetedBase)
  {
    // gentle facets, convex and concave by 2 to 5 degrees
    Geometry g = blocks({{{0.3, 1e-3}, {0.8, 0.6}, {0.3, 0.8}}});
    double   slope[]{0., 3., -2., 0., -4., -4., 1.};
    Vec2     node(0., 0.);
    g.foundation_nodes.push_back(node);
    for (const double s : slope)
      g.foundation_nodes.push_back(node += Vec2(std::cos(s * degree), std::sin(s * degree)));
    ContactDetection detection(parameters);
    Contacts         contacts;
    const double     step_length = 0.0137;
    double           slip        = 0.;
    int              segments = 0, last = -1;
    for (double x = 0.3; x < 6.4; x += step_length)
      {
        // height of the foundation there, 10 um of penetration
        int s = 0;
        while (g.foundation_nodes[s + 1].x() < x)
          ++s;
        const Vec2  &a = g.foundation_nodes[s], &b = g.foundation_nodes[s + 1];
        const double y = a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x()) - 1e-5;
        move_block(g, 0, Vec2(x, y) - g.vertices[0]);
        // the step's solution: slip grows on the edge known at its start
        for (Contact &c : contacts)
          if (c.vertex_body == 0 && c.vertex == 0)
            {
              const Edge   e = edge_of(g, foundation_body, c.edge);
              const double t = (g.vertices[0] - e.a).dot(e.d) / e.length;
              c.slip += (t - c.edge_position) * e.length;
              c.edge_position = t;
              c.plastic_slip  = c.slip - 1e-5;
              slip            = c.slip;
            }
        detection.update(g, contacts);
        ASSERT_EQ(count_vertex(contacts, 0), 1) << "x " << x;
        const Contact &c = *std::find_if(contacts.begin(), contacts.end(), [](const Contact &k) {
          return k.vertex_body == 0;
        });
        EXPECT_NEAR(c.slip, slip, 1e-12) << "x " << x;
        segments += c.edge != last;
        last = c.edge;
      }
    EXPECT_EQ(segments, 7);
    EXPECT_NEAR(slip, 6.1, 0.03);
  }

  TEST(ContactSelection, PlacesOfTheBaseTouchEdgesThatLieAlongThem)
  {
    Geometry g         = blocks({{{0.5, 0.3}, {2.5, 0.3}, {2.5, 1.3}, {0.5, 1.3}}});
    g.foundation_nodes = {{0., 0.}, {1., 0.25}, {1.5, 0.29}, {2., 0.25}, {3., 0.}}; // convex ridge
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    std::vector<int> nodes;
    for (const Contact &c : contacts)
      if (c.vertex_body == foundation_body)
        {
          nodes.push_back(c.vertex);
          EXPECT_EQ(c.edge, 0);
        }
    // the edges beside nodes 1 and 3 fall away from the block's bottom as well
    EXPECT_EQ(nodes, (std::vector<int>{2})) << "nodes 1 and 3 lie lower: angle test";

    for (Vec2 &p : g.foundation_nodes)
      p.y() = 0.29; // flat: the sole lies along all of it
    detection.update(g, contacts);
    nodes.clear();
    for (const Contact &c : contacts)
      if (c.vertex_body == foundation_body)
        nodes.push_back(c.vertex);
    EXPECT_EQ(nodes, (std::vector<int>{1, 2, 3}));
  }

  // ------------------------------------------------------------- odd polygons

  TEST(ContactSelection, NonConvexBlockIsHitOnItsNotch)
  {
    const Outline    l{{0., 0.}, {2., 0.}, {2., 1.}, {1., 1.}, {1., 2.}, {0., 2.}};
    Geometry         g = blocks({l, square(1.0005, 1.0002, 0.5)});
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    EXPECT_NE(find(contacts, 6, 0, 2), nullptr) << "floor of the notch";
    EXPECT_NE(find(contacts, 6, 0, 3), nullptr) << "wall of the notch";
    EXPECT_NE(find(contacts, 7, 0, 2), nullptr);
    EXPECT_NE(find(contacts, 9, 0, 3), nullptr);
    EXPECT_EQ(contacts.size(), 4u) << "the reflex corner touches nothing";
  }

  TEST(ContactSelection, SliverIsSupportedOnItsFace)
  {
    // a sliver of one degree lying flat, thinner than the reach
    Geometry g =
      blocks({square(0., 0., 3.), {{0.5, 3.}, {2.5, 3.}, {0.5, 3. + 2. * std::tan(1. * degree)}}});
    ContactDetection detection(parameters);
    Contacts         contacts;
    for (int step = 0; step < 3; ++step)
      {
        detection.update(g, contacts);
        EXPECT_NE(find(contacts, 4, 0, 2), nullptr);
        EXPECT_NE(find(contacts, 5, 0, 2), nullptr);
        EXPECT_EQ(find(contacts, 6, 0, 2), nullptr) << "the upper corner looks away";
        move_block(g, 1, {0.01, -1e-5});
      }
  }

  TEST(ContactSelection, DeepVertexIsLostAndCounted)
  {
    Geometry         g = blocks({square(0., 0.), {{0.5, 0.5}, {0.7, 1.6}, {0.3, 1.6}}});
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    EXPECT_EQ(detection.report().lost, 1);
    EXPECT_EQ(count_vertex(contacts, 4), 0);
    move_block(g, 1, {0., 0.45});
    detection.update(g, contacts);
    EXPECT_EQ(detection.report().lost, 0);
    EXPECT_NE(find(contacts, 4, 0, 2), nullptr);
  }
} // namespace
