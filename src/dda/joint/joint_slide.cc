// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/joint_law.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  JointLaw::Sliding JointLaw::slide_by_rule(const double  trial,
                                            const double  spring,
                                            const Strain &at,
                                            Sliding       from) const
  {
    // The spring is above the strength at the lower end and not at the upper one: Newton's method,
    // halved where it would leave them.
    double low = 0., high = std::abs(trial) / spring;
    for (int k = 0; k < 100; ++k)
      {
        const double           x     = from.slip.added;
        const SoftenedStrength there = strength.after(from.slip);
        const double           now   = std::max(0., mohr_coulomb(at, there));
        const double           above = std::abs(trial) - spring * x - now;
        (above > 0. ? low : high)    = x;
        from.fall =
          now > 0.
            ? -(there.cohesion_by_slip * (1. - at.damage) + at.normal * there.tan_phi_by_slip)
            : 0.;
        const bool   falls_slowly = from.fall < spring;
        const double step         = falls_slowly ? above / (spring - from.fall) : high - low;
        if (std::abs(step) <= 1e-15 * high || low >= high)
          break;
        const bool stays = falls_slowly && x + step > low && x + step < high;
        from.slip.added  = stays ? x + step : 0.5 * (low + high);
      }
    if (from.fall >= spring)
      from.fall = 0.; // brittle
    return from;
  }
} // namespace hybrid::dda
