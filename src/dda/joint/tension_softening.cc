// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/tension_softening.h>

#include <algorithm>

namespace hybrid::dda
{
  double TensionSoftening::critical_opening() const
  {
    return tensile > 0. ? 2. * fracture_energy / tensile : 0.;
  }



  double TensionSoftening::damage_at(const double gap) const
  {
    const double elastic = tensile / k_n; // opening at the tensile strength
    if (gap <= elastic)
      return 0.;
    const double critical = critical_opening();
    if (gap >= critical || critical <= elastic)
      return 1.;
    return 1. - elastic * (critical - gap) / (gap * (critical - elastic));
  }



  double TensionSoftening::damage_by_gap(const double gap) const
  {
    const double elastic = tensile / k_n, critical = critical_opening();
    if (gap <= elastic || gap >= critical)
      return 0.;
    return elastic * critical / (gap * gap * (critical - elastic));
  }



  double TensionSoftening::largest_opening(const double damage) const
  {
    const double elastic  = tensile / k_n;
    const double critical = std::max(elastic, critical_opening());
    // The linear softening branch has this damage where g = a g_c / (1 - D + a).
    const double a = elastic / std::max(critical - elastic, 1e-300);
    return std::min(critical, a * critical / (1. - damage + a));
  }



  double TensionSoftening::tensile_strength(const double damage) const
  {
    return damage > 0. ? (1. - damage) * k_n * largest_opening(damage) : tensile;
  }



  double TensionSoftening::damage_at_tension(const double tension) const
  {
    const double elastic  = tensile / k_n;
    const double critical = std::max(elastic, critical_opening());
    const double opening  = critical - tension / tensile * (critical - elastic);
    return 1. - tension / (k_n * opening);
  }



  double TensionSoftening::loss(const double damage) const
  {
    if (damage <= 0. || tensile <= 0.)
      return 0.;
    const double elastic  = tensile / k_n;
    const double gap      = largest_opening(damage);
    const double traction = (1. - damage) * k_n * gap;
    return 0.5 * tensile * elastic + 0.5 * (tensile + traction) * (gap - elastic) -
           0.5 * traction * gap;
  }
} // namespace hybrid::dda
