// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/bonded_area.h>
#include <hybrid/dda/polygon.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    constexpr double at_corner = 1e-9; ///< of the edge [-]

    /// The ground's edge that a belt joint bonds: its first end, seen from the ground's body.
    int ground_edge(const Joint &belt)
    {
      return belt.points[belt.other == base_body ? 0 : 1].other_vertex;
    }



    bool bears_cohesion(const Joint &joint)
    {
      return joint.kind == JointKind::belt && joint.law.has_residual_cohesion();
    }



    /// How far a point stands off the ground's edge of a belt joint [m]: 0 where it overlaps.
    double opening(const Joint &belt, const Geometry &g, const Vec2 &point)
    {
      const int   e       = ground_edge(belt);
      const bool  on_base = belt.other == base_body;
      const Vec2 &a       = on_base ? g.base_nodes[e] : g.vertices[e],
                 &b       = on_base ? g.base_nodes[e + 1] : g.vertices[g.next(e)];
      const Vec2   edge   = b - a;
      const double side   = (on_base ? 1. : -1.) * cross(edge, point - a);
      const double part   = edge.dot(point - a) / edge.squaredNorm();
      const bool   faces  = part >= 0. && part <= 1.;
      return faces && side <= 0. ? 0. : distance_to_segment(a, b, point);
    }



    bool is_parted(const Model &model, const DdaState &state, const int j, const int end)
    {
      const Joint        &joint = model.joints[j];
      const Joint::Point &point = joint.points[end];
      const Geometry     &g     = state.geometry;
      const Vec2         &a = g.vertices[joint.edge], &b = g.vertices[g.next(joint.edge)];
      const Vec2          place   = (1. - point.position) * a + point.position * b;
      const double        allowed = joint.law.parting_opening();
      return std::none_of(model.joints.begin(), model.joints.end(), [&](const Joint &belt) {
        return belt.kind == JointKind::belt && opening(belt, g, place) <= allowed;
      });
    }
  } // namespace



  BondedArea::BondedArea(const Model &model, const DdaState &state)
    : edges(model.initial.vertices.size(), 0)
    , segments(model.initial.base_nodes.size(), 0)
  {
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const Joint &joint = model.joints[j];
        if (!bears_cohesion(joint))
          continue;
        (joint.other == base_body ? segments : edges)[ground_edge(joint)] = both;
        for (const int end : {0, 1})
          if (!state.joints[j].parted[end])
            edges[joint.edge] |= joint.points[end].position < at_corner        ? first
                                 : joint.points[end].position > 1. - at_corner ? second
                                                                               : 0;
      }
  }



  void part_opened_belts(const Model &model, DdaState &state)
  {
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        JointState &joint = state.joints[j];
        if (!joint.released || !bears_cohesion(model.joints[j]))
          continue;
        for (const int end : {0, 1})
          joint.parted[end] = joint.parted[end] ||
                              model.joints[j].law.broken_in_tension(joint.points[end].history) ||
                              is_parted(model, state, static_cast<int>(j), end);
      }
  }
} // namespace hybrid::dda
