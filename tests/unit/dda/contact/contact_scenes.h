// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact_detection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

/// Small geometries, and what the tests of contact detection ask about the contacts found.
namespace hybrid::dda::contact_scenes
{
  using Outline  = std::vector<Vec2>;
  using Contacts = std::vector<Contact>;

  constexpr double                       degree = 3.14159265358979323846 / 180.;
  constexpr ContactDetection::Parameters parameters{0.1, 0.05, 1e-3};

  inline void add_block(Geometry &g, const Outline &outline)
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

  inline Geometry blocks(const std::vector<Outline> &outlines)
  {
    Geometry g;
    g.offset.push_back(0);
    for (const Outline &o : outlines)
      add_block(g, o);
    return g;
  }

  /// Vertices: 0 lower left, 1 lower right, 2 upper right, 3 upper left. Edges: 0 bottom, 1 right,
  /// 2 top, 3 left.
  inline Outline square(const double x, const double y, const double size = 1.)
  {
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  }

  inline void move_block(Geometry &g, const int block, const Vec2 &by)
  {
    for (int v = g.offset[block]; v < g.offset[block + 1]; ++v)
      g.vertices[v] += by;
  }

  inline auto key(const Contact &c)
  {
    return std::make_tuple(c.vertex_body, c.vertex, c.edge_body, c.edge);
  }

  inline const Contact *
  find(const Contacts &contacts, const int vertex, const int edge_body, const int edge)
  {
    for (const Contact &c : contacts)
      if (c.vertex_body != foundation_body && c.vertex == vertex && c.edge_body == edge_body &&
          c.edge == edge)
        return &c;
    return nullptr;
  }

  inline int count_vertex(const Contacts &contacts, const int vertex)
  {
    return static_cast<int>(std::count_if(contacts.begin(), contacts.end(), [&](const Contact &c) {
      return c.vertex_body != foundation_body && c.vertex == vertex;
    }));
  }

  inline void expect_equal(const Contacts &a, const Contacts &b)
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

  /// Triangles thrown at random, some of them into each other, above a rough foundation.
  inline Geometry cloud(const int n, const unsigned seed)
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
      g.foundation_nodes.emplace_back(x, height(random));
    return g;
  }

  struct Edge
  {
    Vec2   a, d, n;
    double length;
  };

  inline Edge edge_of(const Geometry &g, const int body, const int e)
  {
    const Vec2 a = body == foundation_body ? g.foundation_nodes[e] : g.vertices[e];
    const Vec2 b = body == foundation_body ? g.foundation_nodes[e + 1] : g.vertices[g.next(e)];
    const Vec2 d = (b - a).normalized();
    return {a,
            d,
            body == foundation_body ? Vec2(-d.y(), d.x()) : Vec2(d.y(), -d.x()),
            (b - a).norm()};
  }
} // namespace hybrid::dda::contact_scenes
