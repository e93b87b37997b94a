// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/bedding_strength.h>
#include <hybrid/dda/joint/tan_degrees.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::dda
{
  JointStrength bedding_strength(const scene::BeddingParameters &bedding)
  {
    if (!bedding.slips)
      return JointStrength::unlimited_bond();
    JointStrength s;
    s.cohesion = bedding.cohesion;
    s.tan_phi = s.residual_tan_phi = tan_degrees(bedding.friction_angle);
    s.tensile        = s.tan_phi > 0. ? std::min(bedding.tensile_strength, s.cohesion / s.tan_phi)
                                      : bedding.tensile_strength;
    s.softening_slip = std::numeric_limits<double>::infinity();
    return s;
  }
} // namespace hybrid::dda
