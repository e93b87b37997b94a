// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/bond_law.h>

namespace hybrid::dda
{
  /// Bond of a sliding belt, an old shear zone: residual as the material says, else as the peak.
  /// Opening takes all cohesion for good, as on bedding planes.
  BondLaw belt_bond();

  JointStrength
  belt_strength(const Material &material, double fracture_energy, double softening_slip);

  /// Contact on a belt: its residual strength, the cohesion on the area that is bonded still.
  JointStrength broken_belt_strength(const Material &material);
} // namespace hybrid::dda
