// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::dda
{
  /// A bond in tension: elastic up to F_t, then linear softening of the traction to zero at the
  /// critical opening g_c = 2 G_f / F_t; brittle if g_c <= F_t / k_n. Unloading to the origin with
  /// (1 - D) k_n.
  struct TensionSoftening
  {
    double tensile;         ///< F_t [Pa]
    double fracture_energy; ///< G_f [J/m2]
    double k_n;             ///< [Pa/m]

    /// Opening at which no traction is left [m]; 0 without tensile strength.
    double critical_opening() const;

    double damage_at(double gap) const;

    /// Derivative of damage_at().
    double damage_by_gap(double gap) const;

    /// Opening of the softening branch at which the bond had got this damage [m].
    double largest_opening(double damage) const;

    /// Tension that a bond with this damage bears [Pa]: F_t, or what is left of it.
    double tensile_strength(double damage) const;

    /// Damage with which the softening branch bears this tension [-], at most F_t.
    double damage_at_tension(double tension) const;

    /// Energy that damage has consumed per area so far [J/m2], from 0 to G_f.
    double loss(double damage) const;
  };
} // namespace hybrid::dda
