// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/bond_law.h>

namespace hybrid::dda
{
  /// Bond between blocks of a material: peak strength, residual as the material says, else friction
  /// only; contacts have the residual.
  BondLaw rock_bond();

  JointStrength
  bond_strength(const Material &material, double fracture_energy, double softening_slip);

  /// Contact without any bond: residual strength only.
  JointStrength contact_strength(const Material &material);
} // namespace hybrid::dda
