// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of random triangles, found once more by looking at all pairs.
#include "contact_scenes.h"

#include <hybrid/dda/geometry/polygon.h>

#include <Eigen/LU>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::dda::contact_scenes;

  struct Found
  {
    Contact c;
    double  gap;
    Vec2    n;
    bool    has_passed;
  };

  bool cross_between_ends(const Edge &a, const Edge &b)
  {
    Eigen::Matrix2d sides;
    sides << a.length * a.d, -b.length * b.d;
    const Vec2 parts = sides.inverse() * (b.a - a.a);
    return parts.minCoeff() > 0. && parts.maxCoeff() < 1.;
  }

  /// Rule 3: behind the edge the vertex is outside of the triangle by the side that meets the edge
  /// at its near end. That tip is in the triangle of the vertex, or a side of the vertex crosses
  /// the edge.
  bool has_passed_tip(const Geometry &g, const int vertex, const int e)
  {
    const int   block = g.block_of[e], own = g.block_of[vertex];
    const Vec2 &p    = g.vertices[vertex];
    const bool  near = (p - g.vertices[e]).norm() <= (p - g.vertices[g.next(e)]).norm();
    const int   tip = near ? e : g.next(e), side = near ? g.previous(e) : tip;
    const Edge  edge = edge_of(g, block, e), beside = edge_of(g, block, side);
    const Vec2  way = p - g.vertices[tip];
    return (p - edge.a).dot(edge.n) < -1e-7 && way.norm() <= parameters.reach &&
           way.dot(beside.n) >= -1e-7 &&
           (contains(&g.vertices[g.offset[own]], 3, g.vertices[tip]) ||
            cross_between_ends(edge, edge_of(g, own, vertex)) ||
            cross_between_ends(edge, edge_of(g, own, g.previous(vertex))));
  }

  /// How much contacts of one vertex may differ in height at a seam [m].
  double seam_height(const double deepest)
  {
    return 1e-3 * parameters.reach + 0.5 * std::max(0., -deepest);
  }

  /// Rule 4, below a seam: beside the edge's end its triangle goes on level with what carries the
  /// vertex.
  bool goes_on_level(const Geometry &g, const Found &f, const Found &support)
  {
    const int b = f.c.edge_body;
    if (support.c.edge_body == b)
      return false;
    for (const int e : {g.previous(f.c.edge), g.next(f.c.edge)})
      {
        const Edge   other = edge_of(g, b, e);
        const double gap   = (g.vertices[f.c.vertex] - other.a).dot(other.n);
        if (other.n.dot(f.n) < 0.9848 && other.n.dot(support.n) >= 0.9848 &&
            std::abs(gap - support.gap) <= seam_height(support.gap))
          return true;
      }
    return false;
  }

  /// The line of what carries a vertex runs over a tip of another block, from which both edges lead
  /// away.
  bool runs_over_tip(const Geometry &g, const Found &support, const int tip)
  {
    const int    block = g.block_of[tip];
    const Edge   after = edge_of(g, block, tip), before = edge_of(g, block, g.previous(tip));
    const double height = support.gap + support.n.dot(after.a - g.vertices[support.c.vertex]);
    return support.c.edge_body != block && support.n.dot(after.d) < -0.1736 &&
           support.n.dot(before.d) > 0.1736 && height <= seam_height(support.gap);
  }

  /// Rule 4: a side below a row that carries the vertex.
  bool is_side_below(const Geometry &g, const Found &f, const Found &support)
  {
    return runs_over_tip(g, support, f.c.edge) || runs_over_tip(g, support, g.next(f.c.edge));
  }

  /// Rule 4: a tip below a row that carries the end of the edge.
  bool is_tip_below(const Geometry &g, const Found &f, const Found &support)
  {
    const Edge edge = edge_of(g, f.c.edge_body, f.c.edge);
    const Vec2 way  = g.vertices[f.c.vertex] - g.vertices[support.c.vertex];
    return (support.c.vertex == f.c.edge || support.c.vertex == g.next(f.c.edge)) &&
           std::abs(edge.d.dot(way)) <= 0.1 * parameters.reach &&
           runs_over_tip(g, support, f.c.vertex);
  }

  /// All pairs of new contacts between triangles, straight from rules 1 to 7 of the header.
  Contacts all_pairs_between_blocks(const Geometry &g)
  {
    const double       reach = parameters.reach;
    std::vector<Found> found;
    for (int v = 0; v < static_cast<int>(g.vertices.size()); ++v)
      {
        std::vector<Found> here;
        for (int b = 0; b < g.n_blocks(); ++b)
          {
            Found best{{-2, 0, 0, 0}, -1e9, Vec2::Zero(), false};
            for (int e = g.offset[b]; e < g.offset[b + 1]; ++e)
              {
                const Edge edge = edge_of(g, b, e);
                const Vec2 r = g.vertices[v] - edge.a, to_next = edge_of(g, g.block_of[v], v).d,
                           to_previous = -edge_of(g, g.block_of[v], g.previous(v)).d;
                const double gap = r.dot(edge.n), along = r.dot(edge.d);
                const bool   has_passed = has_passed_tip(g, v, e);
                if (b != g.block_of[v] && std::abs(gap) <= reach && along >= 0. &&
                    along <= edge.length && edge.n.dot(to_next) >= -0.0523 &&
                    edge.n.dot(to_previous) >= -0.0523 &&
                    (gap > -1e-7 || contains(&g.vertices[g.offset[b]], 3, g.vertices[v]) ||
                     has_passed) &&
                    std::make_pair(has_passed, gap) > std::make_pair(best.has_passed, best.gap))
                  best = {{g.block_of[v], v, b, e}, gap, edge.n, has_passed};
              }
            if (best.c.vertex_body >= 0)
              here.push_back(best);
          }
        const std::vector<Found> touched = here;
        here.erase(std::remove_if(here.begin(),
                                  here.end(),
                                  [&](const Found &f) {
                                    return std::any_of(touched.begin(),
                                                       touched.end(),
                                                       [&](const Found &support) {
                                                         return goes_on_level(g, f, support) ||
                                                                is_side_below(g, f, support);
                                                       });
                                  }),
                   here.end());
        std::sort(here.begin(), here.end(), [](const Found &a, const Found &b) {
          return a.gap < b.gap;
        });
        std::vector<Found> kept;
        for (const Found &f : here)
          if (std::none_of(kept.begin(), kept.end(), [&](const Found &k) {
                return k.n.dot(f.n) >= 0.9848 &&
                       std::abs(k.gap - f.gap) <= seam_height(std::min(k.gap, f.gap));
              }))
            kept.push_back(f);
        found.insert(found.end(), kept.begin(), kept.end());
      }
    Contacts result;
    for (const Found &f : found)
      if (std::none_of(found.begin(), found.end(), [&](const Found &o) {
            return is_tip_below(g, f, o) ||
                   (f.gap < 0. && o.gap < 0. && o.gap > f.gap && o.c.edge_body == f.c.vertex_body &&
                    (o.c.vertex == f.c.edge || o.c.vertex == g.next(f.c.edge)) &&
                    (o.c.edge == f.c.vertex || g.next(o.c.edge) == f.c.vertex) &&
                    -o.n.dot(f.n) < 0.9848);
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
        g.foundation_nodes.clear();
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
} // namespace
