// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/joint_strength.h>

namespace hybrid::dda
{
  JointStrength JointStrength::unlimited_bond()
  {
    JointStrength s = unlimited_friction();
    s.tensile       = std::numeric_limits<double>::infinity();
    return s;
  }



  JointStrength JointStrength::unlimited_friction()
  {
    JointStrength s;
    s.cohesion = s.residual_cohesion = std::numeric_limits<double>::infinity();
    return s;
  }



  JointStrength JointStrength::roller()
  {
    JointStrength s;
    s.tensile = std::numeric_limits<double>::infinity();
    return s;
  }



  JointStrength JointStrength::weaker_of(const JointStrength &other) const
  {
    JointStrength s = *this;
    s.tan_phi = s.residual_tan_phi = std::min(residual_tan_phi, other.residual_tan_phi);
    s.cohesion = s.residual_cohesion = std::min(residual_cohesion, other.residual_cohesion);
    return s;
  }
} // namespace hybrid::dda
