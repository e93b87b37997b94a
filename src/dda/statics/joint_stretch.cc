// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/joint_stretch.h>

namespace hybrid::dda
{
  void
  stretch(const Model &model, const Joint &joint, const JointTraction &traction, SpringState &point)
  {
    const Geometry &g  = model.initial;
    const Vec2 tangent = (g.vertices[g.next(joint.edge)] - g.vertices[joint.edge]).normalized();
    const Vec2 normal(tangent.y(), -tangent.x());
    point        = {};
    point.gap    = -traction.normal / joint.law.normal_stiffness();
    point.slip   = -traction.shear / joint.law.shear_stiffness();
    point.jump   = point.gap * normal + point.slip * tangent;
    point.normal = point.elastic_normal = traction.normal;
    point.shear = point.elastic_shear = traction.shear;
    point.history.damage              = traction.broken ? 1. : 0.;
    if (traction.broken && traction.normal <= 0.)
      point.state = ContactState::open;
  }
} // namespace hybrid::dda
