// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/block_materials.h>

#include <algorithm>

namespace hybrid::dda
{
  Material BlockMaterials::bond(const int region, const int other, const bool saturated) const
  {
    const Material &a = mass(region, saturated), &b = mass(other, saturated);
    if (&a == &b)
      return a;
    const auto residual_angle = [](const Material &m) {
      return m.residual_friction_angle < 0. ? m.friction_angle : m.residual_friction_angle;
    };
    Material weaker                = a;
    weaker.friction_angle          = std::min(a.friction_angle, b.friction_angle);
    weaker.residual_friction_angle = std::min(residual_angle(a), residual_angle(b));
    weaker.cohesion                = std::min(a.cohesion, b.cohesion);
    weaker.residual_cohesion       = std::min(a.residual_cohesion, b.residual_cohesion);
    weaker.tensile_strength        = std::min(a.tensile_strength, b.tensile_strength);
    return weaker;
  }
} // namespace hybrid::dda
