// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/soles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace hybrid::dda
{
  namespace
  {
    constexpr double near_ground = 0.05; ///< distance of a sole from the ground over its length [-]
    constexpr double parallel    = 0.85; ///< cosine of the largest angle between sole and ground



    /// An edge whose block is on its left side.
    struct SoleEdge
    {
      int  first, second;
      Vec2 a, b;
      bool base = false; ///< its ends are nodes of the base
    };



    /// Edges of the blocks from @p begin to @p end that they do not share with each other.
    std::vector<SoleEdge> outer_edges(const Geometry &g, const int begin, const int end)
    {
      std::set<std::array<double, 4>> drawn;
      std::vector<SoleEdge>           edges;
      for (int v = g.offset[begin]; v < g.offset[end]; ++v)
        {
          const Vec2 &a = g.vertices[v], &b = g.vertices[g.next(v)];
          drawn.insert({a.x(), a.y(), b.x(), b.y()});
          edges.push_back({v, g.next(v), a, b});
        }
      std::vector<SoleEdge> outer;
      for (const SoleEdge &edge : edges)
        if (drawn.count({edge.b.x(), edge.b.y(), edge.a.x(), edge.a.y()}) == 0)
          outer.push_back(edge);
      return outer;
    }



    /// The ground that a point of a sole lies on; Ground::first is negative where there is none.
    SoleGround ground_below(const std::vector<SoleEdge> &ground,
                            const SoleEdge              &sole,
                            const double                 fraction_of_sole)
    {
      const Vec2 point     = (1. - fraction_of_sole) * sole.a + fraction_of_sole * sole.b,
                 along     = sole.b - sole.a;
      const double length  = along.norm();
      double       nearest = near_ground * length;
      SoleGround   below;
      for (const SoleEdge &other : ground)
        {
          const Vec2   edge  = other.b - other.a;
          const double width = edge.norm();
          if (!(width > 0.)) // both sides of a bedding plane that ends on the sliding surface
            continue;
          const double fraction = (point - other.a).dot(edge) / (width * width);
          if (fraction < 0. || fraction > 1. || along.dot(edge) > -parallel * length * width)
            continue;
          const double distance = std::abs(cross(edge, point - other.a)) / width;
          if (distance >= nearest)
            continue;
          nearest = distance;
          below   = {other.base, other.first, other.second, fraction};
        }
      return below;
    }



    /// The point of the ground that is nearest.
    Vec2 nearest_of(const std::vector<SoleEdge> &ground, const Vec2 &point)
    {
      Vec2   nearest  = point;
      double distance = std::numeric_limits<double>::infinity();
      for (const SoleEdge &edge : ground)
        {
          const Vec2   along   = edge.b - edge.a;
          const double squared = along.squaredNorm();
          if (!(squared > 0.)) // as above
            continue;
          const double fraction = std::clamp((point - edge.a).dot(along) / squared, 0., 1.);
          const Vec2   other    = (1. - fraction) * edge.a + fraction * edge.b;
          if ((other - point).norm() < distance)
            {
              nearest  = other;
              distance = (other - point).norm();
            }
        }
      return nearest;
    }



    /// Everything that the mass can lie on.
    std::vector<SoleEdge> ground_of(const Model &model)
    {
      std::vector<SoleEdge> ground;
      if (model.n_bedrock > 0)
        ground = outer_edges(model.initial, model.n_mass(), model.n_blocks());
      for (int k = 0; k + 1 < model.n_foundation_nodes(); ++k) // left to right: the ground is below
        ground.push_back({k + 1,
                          k,
                          model.initial.foundation_nodes[k + 1],
                          model.initial.foundation_nodes[k],
                          true});
      return ground;
    }
  } // namespace



  std::vector<Sole> find_soles(const Model &model)
  {
    std::vector<Sole>           soles;
    const std::vector<SoleEdge> ground = ground_of(model);
    for (const SoleEdge &edge : outer_edges(model.initial, 0, model.n_mass()))
      for (const double fraction : {0.5, 0.25, 0.75, 0.02, 0.98})
        if (const SoleGround below = ground_below(ground, edge, fraction); below.first >= 0)
          {
            soles.push_back({edge.first,
                             edge.second,
                             fraction,
                             below,
                             (1. - fraction) * edge.a + fraction * edge.b,
                             (edge.b - edge.a).norm(),
                             {nearest_of(ground, edge.a), nearest_of(ground, edge.b)}});
            break;
          }
    return soles;
  }
} // namespace hybrid::dda
