// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/springs/torn_bond.h>

namespace hybrid::dda
{
  namespace
  {
    struct Part
    {
      double traction = 0., derivative = 0.;
    };



    /// @param carried traction with its weight [Pa]  @param way over which it acts [m]
    /// @param stored that it may give [J/m2]
    Part
    beyond_stored(const double carried, const double way, const double stored, const double gamma)
    {
      if (!(carried * way > stored))
        return {};
      return {(carried - stored / way) / gamma, stored / (gamma * way * way)};
    }
  } // namespace



  TakenBack taken_back(const Springs::Spring &spring, const SpringState &now, const double gamma)
  {
    const double was  = spring.contact_fraction,
                 torn = spring.law->contact_fraction(now.history) - was;
    if (!(torn > 0.))
      return {};
    const SpringState      &old     = spring.old;
    const Springs::Traction contact = spring.contact_traction(old);
    const double            weight  = (1. - gamma) * torn / (1. - was);
    const double            stretch = old.slip - old.history.plastic_slip;
    const Part              normal =
      beyond_stored(weight * (old.normal - contact.normal),
                    now.gap - old.gap,
                    0.5 * torn * spring.law->normal_stiffness() * old.gap * old.gap,
                    gamma);
    const Part shear = beyond_stored(weight * (old.shear - contact.shear),
                                     now.slip - old.slip,
                                     0.5 * torn * spring.law->shear_stiffness() * stretch * stretch,
                                     gamma);
    return {{normal.traction, shear.traction}, normal.derivative, shear.derivative};
  }
} // namespace hybrid::dda
