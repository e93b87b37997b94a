// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/belt_bond.h>
#include <hybrid/dda/joint/rock_bond.h>

namespace hybrid::dda
{
  JointStrength
  belt_strength(const Material &material, const double fracture_energy, const double softening_slip)
  {
    JointStrength s = bond_strength(material, fracture_energy, softening_slip);
    if (material.residual_cohesion < 0.)
      s.residual_cohesion = s.cohesion;
    s.opening_ends_cohesion = true;
    return s;
  }



  JointStrength broken_belt_strength(const Material &material)
  {
    JointStrength s     = contact_strength(material);
    s.residual_cohesion = belt_strength(material, 0., 0.).residual_cohesion;
    s.cohesion          = s.residual_cohesion;
    return s;
  }



  BondLaw belt_bond()
  {
    return {"belt", belt_strength, broken_belt_strength};
  }
} // namespace hybrid::dda
