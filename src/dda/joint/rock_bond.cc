// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/rock_bond.h>
#include <hybrid/dda/joint/tan_degrees.h>

namespace hybrid::dda
{
  JointStrength
  bond_strength(const Material &material, const double fracture_energy, const double softening_slip)
  {
    JointStrength s;
    s.tensile           = material.tensile_strength;
    s.cohesion          = material.cohesion;
    s.tan_phi           = tan_degrees(material.friction_angle);
    s.residual_cohesion = std::max(0., material.residual_cohesion);
    s.residual_tan_phi  = material.residual_friction_angle < 0.
                            ? s.tan_phi
                            : tan_degrees(material.residual_friction_angle);
    s.fracture_energy   = fracture_energy;
    s.softening_slip    = softening_slip;
    return s;
  }



  JointStrength contact_strength(const Material &material)
  {
    JointStrength s = bond_strength(material, 0., 0.);
    s.tensile       = 0.;
    s.cohesion      = s.residual_cohesion;
    s.tan_phi       = s.residual_tan_phi;
    return s;
  }



  BondLaw rock_bond()
  {
    return {"bond", bond_strength, contact_strength};
  }
} // namespace hybrid::dda
