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
  };

  /// True if the sides of two corners cross, all but one pair at most, and neither corner is in the
  /// other's block.
  bool corners_cross(const Geometry &g, const int p, const int q)
  {
    const auto in_block_of = [&](const int inner, const int other) {
      return contains(&g.vertices[g.offset[g.block_of[other]]], 3, g.vertices[inner]);
    };
    if ((g.vertices[p] - g.vertices[q]).norm() > parameters.reach || in_block_of(p, q) ||
        in_block_of(q, p))
      return false;
    int crossings = 0;
    for (const int a : {p, g.previous(p)})
      for (const int b : {q, g.previous(q)})
        {
          Eigen::Matrix2d sides;
          sides << g.vertices[g.next(a)] - g.vertices[a], g.vertices[b] - g.vertices[g.next(b)];
          const Vec2 parts = sides.inverse() * (g.vertices[b] - g.vertices[a]);
          if (parts.minCoeff() > 0. && parts.maxCoeff() < 1.)
            ++crossings;
        }
    return crossings >= 3;
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
                    (gap > -1e-7 || contains(&g.vertices[g.offset[b]], 3, g.vertices[v]) ||
                     corners_cross(g, v, along < 0.5 * edge.length ? e : g.next(e))) &&
                    gap > best.gap)
                  best = {{g.block_of[v], v, b, e}, gap, edge.n};
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
                                                         return goes_on_level(g, f, support);
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
