// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact_detection.h>
#include <hybrid/dda/polygon.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using Outline  = std::vector<Vec2>;
  using Contacts = std::vector<Contact>;

  constexpr double                       degree = 3.14159265358979323846 / 180.;
  constexpr ContactDetection::Parameters parameters{0.1, 0.05, 1e-3};

  void add_block(Geometry &g, const Outline &outline)
  {
    if (g.offset.empty())
      g.offset.push_back(0);
    for (const Vec2 &p : outline)
      {
        g.vertices.push_back(p);
        g.block_of.push_back(static_cast<int>(g.offset.size()) - 1);
      }
    g.offset.push_back(static_cast<int>(g.vertices.size()));
  }

  Geometry blocks(const std::vector<Outline> &outlines)
  {
    Geometry g;
    g.offset.push_back(0);
    for (const Outline &o : outlines)
      add_block(g, o);
    return g;
  }

  /// Vertices: 0 lower left, 1 lower right, 2 upper right, 3 upper left. Edges: 0 bottom, 1 right,
  /// 2 top, 3 left.
  Outline square(const double x, const double y, const double size = 1.)
  {
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  }

  void move_block(Geometry &g, const int block, const Vec2 &by)
  {
    for (int v = g.offset[block]; v < g.offset[block + 1]; ++v)
      g.vertices[v] += by;
  }

  auto key(const Contact &c)
  {
    return std::make_tuple(c.vertex_body, c.vertex, c.edge_body, c.edge);
  }

  const Contact *
  find(const Contacts &contacts, const int vertex, const int edge_body, const int edge)
  {
    for (const Contact &c : contacts)
      if (c.vertex_body != base_body && c.vertex == vertex && c.edge_body == edge_body &&
          c.edge == edge)
        return &c;
    return nullptr;
  }

  int count_vertex(const Contacts &contacts, const int vertex)
  {
    return static_cast<int>(std::count_if(contacts.begin(), contacts.end(), [&](const Contact &c) {
      return c.vertex_body != base_body && c.vertex == vertex;
    }));
  }

  void expect_equal(const Contacts &a, const Contacts &b)
  {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      {
        EXPECT_EQ(key(a[i]), key(b[i]));
        EXPECT_EQ(a[i].edge_position, b[i].edge_position);
        EXPECT_EQ(a[i].slip, b[i].slip);
        EXPECT_EQ(a[i].plastic_slip, b[i].plastic_slip);
        EXPECT_EQ(a[i].state, b[i].state);
      }
  }

  /// Triangles thrown at random, some of them into each other, above a rough base.
  Geometry cloud(const int n, const unsigned seed)
  {
    std::mt19937                           random(seed);
    const double                           side = 0.8 * std::sqrt(n);
    std::uniform_real_distribution<double> place(0., side), angle(0., 360. * degree),
      size(0.3, 0.6);
    Geometry g;
    g.offset.push_back(0);
    for (int i = 0; i < n; ++i)
      {
        const Vec2   c(place(random), place(random));
        const double a = angle(random);
        Outline      t;
        for (int k = 0; k < 3; ++k)
          {
            const double phi = a + k * 120. * degree;
            t.push_back(c + size(random) * Vec2(std::cos(phi), std::sin(phi)));
          }
        add_block(g, t);
      }
    std::uniform_real_distribution<double> height(-0.2, 0.4);
    for (double x = -1.; x < side + 1.; x += 0.7)
      g.base_nodes.emplace_back(x, height(random));
    return g;
  }

  // ---------------------------------------------------------------- oracle

  struct Edge
  {
    Vec2   a, d, n;
    double length;
  };

  Edge edge_of(const Geometry &g, const int body, const int e)
  {
    const Vec2 a = body == base_body ? g.base_nodes[e] : g.vertices[e];
    const Vec2 b = body == base_body ? g.base_nodes[e + 1] : g.vertices[g.next(e)];
    const Vec2 d = (b - a).normalized();
    return {a, d, body == base_body ? Vec2(-d.y(), d.x()) : Vec2(d.y(), -d.x()), (b - a).norm()};
  }

  struct Found
  {
    Contact c;
    double  gap;
    Vec2    n;
  };

  /// All pairs of new contacts between triangles, straight from rules 1, 2, 3, 5, 6 and 7 of the
  /// header.
  Contacts all_pairs_between_blocks(const Geometry &g)
  {
    const double       reach = parameters.reach;
    std::vector<Found> found;
    for (int v = 0; v < static_cast<int>(g.vertices.size()); ++v)
      {
        std::vector<Found> here;
        for (int b = 0; b < g.n_blocks(); ++b)
          {
            Found best{{-2, 0, 0, 0}, -1e9, Vec2::Zero()};
            for (int e = g.offset[b]; e < g.offset[b + 1]; ++e)
              {
                const Edge edge = edge_of(g, b, e);
                const Vec2 r = g.vertices[v] - edge.a, to_next = edge_of(g, g.block_of[v], v).d,
                           to_previous = -edge_of(g, g.block_of[v], g.previous(v)).d;
                const double gap = r.dot(edge.n), along = r.dot(edge.d);
                if (b != g.block_of[v] && std::abs(gap) <= reach && along >= 0. &&
                    along <= edge.length && edge.n.dot(to_next) >= -0.0523 &&
                    edge.n.dot(to_previous) >= -0.0523 &&
                    (gap > -1e-7 || contains(&g.vertices[g.offset[b]], 3, g.vertices[v])) &&
                    gap > best.gap)
                  best = {{g.block_of[v], v, b, e}, gap, edge.n};
              }
            if (best.c.vertex_body >= 0)
              here.push_back(best);
          }
        std::sort(here.begin(), here.end(), [](const Found &a, const Found &b) {
          return a.gap < b.gap;
        });
        std::vector<Found> kept;
        for (const Found &f : here)
          if (std::none_of(kept.begin(), kept.end(), [&](const Found &k) {
                return k.n.dot(f.n) >= 0.9848 &&
                       std::abs(k.gap - f.gap) <=
                         1e-3 * reach + 0.5 * std::max({0., -k.gap, -f.gap});
              }))
            kept.push_back(f);
        found.insert(found.end(), kept.begin(), kept.end());
      }
    Contacts result;
    for (const Found &f : found)
      if (std::none_of(found.begin(), found.end(), [&](const Found &o) {
            return f.gap < 0. && o.gap < 0. && o.gap > f.gap && o.c.edge_body == f.c.vertex_body &&
                   (o.c.vertex == f.c.edge || o.c.vertex == g.next(f.c.edge)) &&
                   (o.c.edge == f.c.vertex || g.next(o.c.edge) == f.c.vertex) &&
                   -o.n.dot(f.n) < 0.9848;
          }))
        result.push_back(f.c);
    std::sort(result.begin(), result.end(), [](const Contact &a, const Contact &b) {
      return key(a) < key(b);
    });
    return result;
  }

  TEST(ContactDetection, GridEqualsAllPairsForRandomTriangles)
  {
    std::size_t total = 0;
    for (unsigned seed = 1; seed <= 20; ++seed)
      {
        Geometry g = cloud(120, seed);
        g.base_nodes.clear();
        ContactDetection detection(parameters);
        Contacts         contacts;
        detection.update(g, contacts);
        const Contacts expected = all_pairs_between_blocks(g);
        ASSERT_EQ(contacts.size(), expected.size()) << "seed " << seed;
        for (std::size_t i = 0; i < contacts.size(); ++i)
          EXPECT_EQ(key(contacts[i]), key(expected[i])) << "seed " << seed;
        total += contacts.size();
      }
    EXPECT_GT(total, 1000u);
  }

  /// 60 steps of a drifting cloud; history is written as an accepting solver would.
  Contacts drift(Geometry g, const double margin, long &builds)
  {
    ContactDetection detection({parameters.reach, margin, parameters.smooth_angle});
    Contacts         contacts;
    for (int step = 0; step < 60; ++step)
      {
        detection.update(g, contacts);
        for (Contact &c : contacts)
          {
            c.slip += 1e-3 * c.edge_position;
            c.plastic_slip = 0.5 * c.slip;
            c.state        = ContactState::sliding;
          }
        for (int b = 0; b < g.n_blocks(); ++b)
          move_block(g, b, 0.004 * Vec2(std::sin(3. * b), std::cos(5. * b + 0.1 * step)));
      }
    builds = detection.report().builds;
    return contacts;
  }

  TEST(ContactDetection, ResultDoesNotDependOnWhenTheListWasBuilt)
  {
    const Geometry g = cloud(300, 5);
    long           every_step, seldom, never;
    const Contacts a = drift(g, 0., every_step), b = drift(g, 0.08, seldom),
                   c = drift(g, 10., never);
    EXPECT_EQ(every_step, 60);
    EXPECT_GT(seldom, 1);
    EXPECT_LT(seldom, 20);
    EXPECT_EQ(never, 1);
    EXPECT_GT(a.size(), 200u);
    expect_equal(a, b);
    expect_equal(a, c);
  }

  TEST(ContactDetection, PermutedBlocksGiveTheSameContacts)
  {
    const Geometry   g = cloud(200, 9);
    std::vector<int> order(g.n_blocks());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    Geometry p;
    p.base_nodes = g.base_nodes;
    for (const int b : order)
      add_block(p, Outline(g.vertices.begin() + g.offset[b], g.vertices.begin() + g.offset[b + 1]));

    ContactDetection dg(parameters), dp(parameters);
    Contacts         cg, cp;
    dg.update(g, cg);
    dp.update(p, cp);
    const auto vertex = [&](const int body, const int v) {
      return body == base_body ? v : 3 * order[v / 3] + v % 3;
    };
    for (Contact &c : cp)
      {
        c.vertex = vertex(c.vertex_body, c.vertex);
        c.edge   = vertex(c.edge_body, c.edge);
        for (int *body : {&c.vertex_body, &c.edge_body})
          *body = *body == base_body ? base_body : order[*body];
      }
    std::sort(cp.begin(), cp.end(), [](const Contact &a, const Contact &b) {
      return key(a) < key(b);
    });
    expect_equal(cg, cp);
    EXPECT_EQ(dg.report().lost, dp.report().lost);
  }

  // ------------------------------------------------------------- mesh of squares

  TEST(ContactDetection, CoincidentCornersOfAStackTouchTheirNeighboursOnly)
  {
    const int columns = 10, rows = 5;
    Geometry  g;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        add_block(g, square(i, j));
    for (int i = -1; i <= columns + 1; ++i)
      g.base_nodes.emplace_back(i, 0.);

    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    for (const Contact &c : contacts)
      {
        ASSERT_NE(c.vertex_body, base_body) << "collinear base nodes are no vertices";
        if (c.edge_body == base_body)
          continue;
        const int d = std::abs(c.vertex_body - c.edge_body);
        EXPECT_TRUE(d == 1 || d == columns)
          << c.vertex_body << " touches " << c.edge_body << " over the corner";
        EXPECT_TRUE(c.edge_position < 1e-12 || c.edge_position > 1. - 1e-12);
      }
    // every shared edge: two vertices each way; every bottom corner once on the base
    const int shared = (columns - 1) * rows + columns * (rows - 1);
    EXPECT_EQ(contacts.size(), static_cast<std::size_t>(4 * shared + 2 * columns));
  }

  TEST(ContactDetection, RowOfEqualHeightCarriesASlidingSquareWithoutSeam)
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

  TEST(ContactDetection, StepOfTheRowIsAnObstacle)
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

  TEST(ContactDetection, DiagonalSquaresAreUndecidedUntilTheyMove)
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

  TEST(ContactDetection, DiagonalSquaresPassFreely)
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

  TEST(ContactDetection, TipOnTipActsThroughOneEdge)
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

  TEST(ContactDetection, CollinearEdgesTouchBothWays)
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

  TEST(ContactDetection, HistoryDecidesThroughWhichEdgeAVertexCame)
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

  // ------------------------------------------------------------- base

  TEST(ContactDetection, SlipIsContinuousAlongAFacetedBase)
  {
    // gentle facets, convex and concave by 2 to 5 degrees
    Geometry g = blocks({{{0.3, 1e-3}, {0.8, 0.6}, {0.3, 0.8}}});
    double   slope[]{0., 3., -2., 0., -4., -4., 1.};
    Vec2     node(0., 0.);
    g.base_nodes.push_back(node);
    for (const double s : slope)
      g.base_nodes.push_back(node += Vec2(std::cos(s * degree), std::sin(s * degree)));
    ContactDetection detection(parameters);
    Contacts         contacts;
    const double     step_length = 0.0137;
    double           slip        = 0.;
    int              segments = 0, last = -1;
    for (double x = 0.3; x < 6.4; x += step_length)
      {
        // height of the base there, 10 um of penetration
        int s = 0;
        while (g.base_nodes[s + 1].x() < x)
          ++s;
        const Vec2  &a = g.base_nodes[s], &b = g.base_nodes[s + 1];
        const double y = a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x()) - 1e-5;
        move_block(g, 0, Vec2(x, y) - g.vertices[0]);
        // the step's solution: slip grows on the edge known at its start
        for (Contact &c : contacts)
          if (c.vertex_body == 0 && c.vertex == 0)
            {
              const Edge   e = edge_of(g, base_body, c.edge);
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

  TEST(ContactDetection, BaseNodesAreVerticesOnlyWhereTheRockSticksOut)
  {
    Geometry g   = blocks({{{0.5, 0.3}, {2.5, 0.3}, {2.5, 1.3}, {0.5, 1.3}}});
    g.base_nodes = {{0., 0.}, {1., 0.25}, {1.5, 0.29}, {2., 0.25}, {3., 0.}}; // convex ridge
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    std::vector<int> nodes;
    for (const Contact &c : contacts)
      if (c.vertex_body == base_body)
        {
          nodes.push_back(c.vertex);
          EXPECT_EQ(c.edge, 0);
        }
    // the edges beside nodes 1 and 3 fall away from the block's bottom as well
    EXPECT_EQ(nodes, (std::vector<int>{2})) << "nodes 1 and 3 lie lower: angle test";

    for (Vec2 &p : g.base_nodes)
      p.y() = 0.29; // flat: no vertices
    detection.update(g, contacts);
    for (const Contact &c : contacts)
      EXPECT_NE(c.vertex_body, base_body);
  }

  TEST(ContactDetection, ValleyActsWithBothSides)
  {
    Geometry g   = blocks({{{0., 1e-3}, {0.1, 1.}, {-0.1, 1.}}});
    g.base_nodes = {{-1., 1.}, {0., 0.}, {1., 1.}};
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    EXPECT_NE(find(contacts, 0, base_body, 0), nullptr);
    EXPECT_NE(find(contacts, 0, base_body, 1), nullptr);

    g.base_nodes = {{-1., -0.02}, {0., 0.}, {1., -0.02}}; // a gentle ridge: one only
    contacts.clear();
    detection.update(g, contacts);
    EXPECT_EQ(count_vertex(contacts, 0), 1);
  }

  // ------------------------------------------------------------- odd polygons

  TEST(ContactDetection, NonConvexBlockIsHitOnItsNotch)
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

  TEST(ContactDetection, SliverIsSupportedOnItsFace)
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

  TEST(ContactDetection, DeepVertexIsLostAndCounted)
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

  // ------------------------------------------------------------- what is skipped

  TEST(ContactDetection, BondedPairsAndSleepingNeighboursAreSkipped)
  {
    Geometry g   = blocks({square(0., 0.), square(1., 0.), square(2., 0.)});
    g.base_nodes = {{-1., 0.}, {1.5, 0.}, {4., 0.}};
    ContactDetection detection(parameters);
    detection.set_neighbours({0, 1, 3, 4}, {1, 0, 2, 1});
    SkippedPairs skipped{{{0, 1}, {1, 2}}, {{0, 0}, {1, 0}, {1, 1}, {2, 1}}, {0, 0, 0}};
    detection.set_skipped_pairs(skipped);
    Contacts contacts;
    detection.update(g, contacts);
    EXPECT_TRUE(contacts.empty()) << "an intact mass has no contacts";

    skipped.bonded      = {{0, 1}}; // joint between 1 and 2 released
    skipped.bonded_base = {{0, 0}, {1, 0}, {1, 1}};
    skipped.awake       = {0, 1, 1};
    detection.set_skipped_pairs(skipped);
    detection.update(g, contacts);
    for (const Contact &c : contacts)
      {
        EXPECT_NE(c.vertex_body, 0);
        EXPECT_NE(c.edge_body, 0);
      }
    EXPECT_NE(find(contacts, 8, base_body, 1), nullptr);
    EXPECT_EQ(find(contacts, 4, base_body, 0), nullptr) << "block 1 is still bonded there";
    EXPECT_EQ(contacts.size(), 6u) << "four between blocks 1 and 2, two below block 2";

    const long builds = detection.report().builds;
    detection.set_skipped_pairs(skipped);
    detection.update(g, contacts);
    EXPECT_EQ(detection.report().builds, builds) << "nothing changed, nothing built";
  }

  // ------------------------------------------------------------- cost

  TEST(ContactDetection, CostIsLinearInTheNumberOfBlocks)
  {
    const auto tests_per_block = [](const int n) {
      Geometry         g = cloud(n, 2);
      ContactDetection detection(parameters);
      Contacts         contacts;
      detection.update(g, contacts);
      return std::make_pair(double(detection.report().edge_tests) / n,
                            double(detection.n_build_tests()) / n);
    };
    const auto small = tests_per_block(1000), large = tests_per_block(10000);
    EXPECT_LT(large.first, 1.2 * small.first);
    EXPECT_LT(large.second, 1.2 * small.second);
    EXPECT_LT(large.first, 60.);
  }

  TEST(ContactDetection, SteadyStateAllocatesNothing)
  {
    Geometry         g = cloud(300, 4);
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    detection.update(g, contacts);
    const Contact    *data     = contacts.data();
    const std::size_t capacity = contacts.capacity();
    for (int i = 0; i < 5; ++i)
      detection.update(g, contacts);
    EXPECT_EQ(contacts.data(), data);
    EXPECT_EQ(contacts.capacity(), capacity);
  }
} // namespace
