// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/failure/belt_parting.h>
#include <hybrid/dda/geometry/polygon.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    /// How far a point stands off the ground's edge of a belt joint [m]: 0 where it overlaps.
    double opening(const Joint &belt, const Geometry &g, const Vec2 &point)
    {
      const int   e             = belt.other_edge();
      const bool  on_foundation = belt.other == foundation_body;
      const Vec2 &a             = on_foundation ? g.foundation_nodes[e] : g.vertices[e],
                 &b             = on_foundation ? g.foundation_nodes[e + 1] : g.vertices[g.next(e)];
      const Vec2   edge         = b - a;
      const double side         = (on_foundation ? 1. : -1.) * cross(edge, point - a);
      const double fraction     = edge.dot(point - a) / edge.squaredNorm();
      const bool   faces        = fraction >= 0. && fraction <= 1.;
      return faces && side <= 0. ? 0. : distance_to_segment(a, b, point);
    }
  } // namespace



  bool
  BeltParting::is_parted(const Model &model, const DdaState &state, const int joint, const int end)
  {
    const Joint        &bond  = model.joints[joint];
    const Joint::Point &point = bond.points[end];
    const Geometry     &g     = state.geometry;
    const Vec2         &a = g.vertices[bond.edge], &b = g.vertices[g.next(bond.edge)];
    const Vec2          place = (1. - point.position) * a + point.position * b;
    const double        allowed =
      bond.law.parting_opening() + std::max(0., -state.joints[joint].drawn_gap[end]);
    const auto lies_on = [&](const int k) {
      return opening(model.joints[belts[k]], g, place) <= allowed;
    };
    int &last = last_belt[joint][end];
    if (lies_on(last))
      return false;
    for (int k = 0; k < static_cast<int>(belts.size()); ++k)
      if (lies_on(k))
        {
          last = k;
          return false;
        }
    return true;
  }



  void BeltParting::update(const Model &model, DdaState &state)
  {
    if (last_belt.empty())
      {
        last_belt.resize(model.joints.size(), {0, 0});
        for (std::size_t j = 0; j < model.joints.size(); ++j)
          if (model.joints[j].kind == JointKind::belt)
            belts.push_back(static_cast<int>(j));
      }
    for (const int j : belts)
      {
        JointState &joint = state.joints[j];
        if (!joint.released || !model.joints[j].bears_residual_cohesion())
          continue;
        for (const int end : {0, 1})
          joint.parted[end] = joint.parted[end] ||
                              model.joints[j].law.broken_in_tension(joint.points[end].history) ||
                              is_parted(model, state, j, end);
      }
  }
} // namespace hybrid::dda
