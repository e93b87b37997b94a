// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/joint_strength.h>
#include <hybrid/scene/material.h>

#include <string>
#include <vector>

namespace hybrid::dda
{
  /// What bonds the blocks of the sliding mass to each other and to the ground. To add one: a file
  /// that returns it, and a line in bond_laws().
  struct BondLaw
  {
    /// Of the joint that bonds. @param fracture_energy G_f [J/m2]. @param softening_slip [m].
    using Bond = JointStrength (*)(const Material &material,
                                   double          fracture_energy,
                                   double          softening_slip);

    /// Of contacts between what it bonded or never bonded.
    using Contact = JointStrength (*)(const Material &material);

    std::string name;
    Bond        bond;
    Contact     contact;
  };


  /// All of them.
  const std::vector<BondLaw> &bond_laws();


  /// Which law holds where.
  struct BondLaws
  {
    BondLaw body; ///< within the sliding mass, and of contacts on anything but a belt
    BondLaw belt; ///< between the mass and what it stands on
  };


  /// Those of these names. @throws InputError if there is none.
  BondLaws choose_bonds(const std::string          &body = "bond",
                        const std::string          &belt = "rate belt",
                        const std::vector<BondLaw> &laws = bond_laws());
} // namespace hybrid::dda
