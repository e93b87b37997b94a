// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/sole_slip.h>
#include <hybrid/restart/archive.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace hybrid::output
{
  namespace
  {
    constexpr double near     = 0.05; ///< distance of a sole from the ground over its length [-]
    constexpr double parallel = 0.85; ///< cosine of the largest angle between sole and ground



    /// An edge whose block is on its left side.
    struct Edge
    {
      int  first, second;
      Vec2 a, b;
      bool base = false; ///< its ends are nodes of the base
    };



    /// Edges of the blocks from @p begin to @p end that they do not share with each other.
    std::vector<Edge> outer_edges(const dda::Geometry &g, const int begin, const int end)
    {
      std::set<std::array<double, 4>> drawn;
      std::vector<Edge>               edges;
      for (int v = g.offset[begin]; v < g.offset[end]; ++v)
        {
          const Vec2 &a = g.vertices[v], &b = g.vertices[g.next(v)];
          drawn.insert({a.x(), a.y(), b.x(), b.y()});
          edges.push_back({v, g.next(v), a, b});
        }
      std::vector<Edge> outer;
      for (const Edge &edge : edges)
        if (drawn.count({edge.b.x(), edge.b.y(), edge.a.x(), edge.a.y()}) == 0)
          outer.push_back(edge);
      return outer;
    }



    /// The ground that a point of a sole lies on; Ground::first is negative where there is none.
    SoleGround
    ground_below(const std::vector<Edge> &ground, const Edge &sole, const double fraction_of_sole)
    {
      const Vec2 point     = (1. - fraction_of_sole) * sole.a + fraction_of_sole * sole.b,
                 along     = sole.b - sole.a;
      const double length  = along.norm();
      double       nearest = near * length;
      SoleGround   below;
      for (const Edge &other : ground)
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



    /// Everything that the mass can lie on.
    std::vector<Edge> ground_of(const dda::Model &model)
    {
      std::vector<Edge> ground;
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



  SoleSlip::SoleSlip(const dda::Model *blocks, const double downhill)
    : sign(downhill < 0. ? -1. : 1.)
  {
    if (blocks != nullptr && blocks->n_mass() > 0)
      find_soles(*blocks);
  }



  void SoleSlip::find_soles(const dda::Model &model)
  {
    const std::vector<Edge> ground = ground_of(model);
    for (const Edge &edge : outer_edges(model.initial, 0, model.n_mass()))
      for (const double fraction : {0.5, 0.25, 0.75, 0.02, 0.98})
        if (const SoleGround below = ground_below(ground, edge, fraction); below.first >= 0)
          {
            soles.push_back({edge.first,
                             edge.second,
                             fraction,
                             below,
                             (1. - fraction) * edge.a + fraction * edge.b,
                             (edge.b - edge.a).norm()});
            break;
          }
  }



  Vec2 SoleSlip::place(const dda::DdaState &state, const Sole &sole)
  {
    const std::vector<Vec2> &v = state.geometry.vertices;
    const SoleGround        &g = sole.ground;
    const Vec2 x = (1. - sole.fraction) * v[sole.first] + sole.fraction * v[sole.second];
    if (!g.base)
      return x - (1. - g.fraction) * v[g.first] - g.fraction * v[g.second];
    const auto &u = state.foundation_displacement;
    return x - (1. - g.fraction) * u.segment<2>(2 * g.first) -
           g.fraction * u.segment<2>(2 * g.second);
  }



  void SoleSlip::set_reference(const dda::DdaState &state)
  {
    for (Sole &sole : soles)
      {
        const Vec2 edge =
          state.geometry.vertices[sole.second] - state.geometry.vertices[sole.first];
        sole.start = place(state, sole);
        sole.along = sign / edge.norm() * edge;
      }
  }



  std::vector<double> SoleSlip::values(const dda::DdaState &state) const
  {
    std::vector<double> slip;
    slip.reserve(soles.size());
    for (const Sole &sole : soles)
      slip.push_back((place(state, sole) - sole.start).dot(sole.along));
    return slip;
  }



  double SoleSlip::mean(const std::vector<double> &slip) const
  {
    double sum = 0., width = 0.;
    for (std::size_t k = 0; k < soles.size(); ++k)
      {
        sum += soles[k].length * slip[k];
        width += soles[k].length;
      }
    return width > 0. ? sum / width : 0.;
  }



  double SoleSlip::part_beyond(const std::vector<double> &slip, const double threshold) const
  {
    double beyond = 0., width = 0.;
    for (std::size_t k = 0; k < soles.size(); ++k)
      {
        beyond += std::abs(slip[k]) > threshold ? soles[k].length : 0.;
        width += soles[k].length;
      }
    return width > 0. ? beyond / width : 0.;
  }



  int SoleSlip::farthest(const std::vector<double> &slip)
  {
    int found = 0;
    for (std::size_t k = 0; k < slip.size(); ++k)
      if (std::abs(slip[k]) > std::abs(slip[found]))
        found = static_cast<int>(k);
    return found;
  }



  void SoleSlip::serialize(restart::Archive &archive)
  {
    std::vector<Vec2> reference;
    for (const Sole &sole : soles)
      {
        reference.push_back(sole.start);
        reference.push_back(sole.along);
      }
    archive(reference);
    for (std::size_t k = 0; archive.is_reading() && k < soles.size(); ++k)
      {
        soles[k].start = reference.at(2 * k);
        soles[k].along = reference.at(2 * k + 1);
      }
  }
} // namespace hybrid::output
