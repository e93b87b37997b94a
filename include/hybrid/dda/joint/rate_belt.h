// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/bond_law.h>

namespace hybrid::dda
{
  /**
   * A belt whose friction depends on the rate v of slip, the direct effect of Dieterich (1979)
   * regularised at rest; of clays Skempton (1985):
   *
   *     mu(v) = mu (1 + a ln(1 + v/v_0))     a >= 0, strengthening
   *     mu(v) = mu / (1 - a ln(1 + v/v_0))   a < 0, weakening, equal to first order in a
   *
   * so friction is never negative. mu follows slip as of belt_bond(); cohesion does not depend on
   * the rate. The rate is that of the step, plastic slip over its duration: implicit, and what
   * slips only dissipates. Materials without a coefficient have the law of belt_bond().
   */
  BondLaw rate_belt();

  /// mu(v) over mu, and its derivative by ln(1 + v/v_0) [-]. @param coefficient a [-]
  struct RateFactor
  {
    double value, derivative;
  };

  RateFactor rate_factor(double coefficient, double logarithm);
} // namespace hybrid::dda
