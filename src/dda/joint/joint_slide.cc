// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/joint_law.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  JointLaw::Sliding JointLaw::slide_linearly(const double  trial,
                                             const double  spring,
                                             const Strain &at,
                                             Sliding       from) const
  {
    const double kappa = from.slip.before;
    const double now   = shear_strength(at, strength.after({kappa}));
    const double end =
      std::isfinite(strength.softening_slip)
        ? shear_strength(at, strength.after({kappa + strength.softening_slip + 1.}))
        : now;                                            // residual
    double       x    = (std::abs(trial) - end) / spring; // residual strength reached
    const double left = std::max(0., strength.softening_slip - kappa);
    if (left > 0. && x < left)
      {
        from.fall = (now - end) / left;
        if (from.fall < spring)
          x = std::max(0., std::min((std::abs(trial) - now) / (spring - from.fall), left));
        else
          from.fall = 0.; // brittle: straight to the residual
      }
    from.slip.added = x;
    return from;
  }



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
        const double           now   = shear_strength(at, there);
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



  void JointLaw::slide(const double       trial,
                       const double       spring,
                       const Strain      &at,
                       const PlasticSlip &slip,
                       JointResponse     &r) const
  {
    const Sliding sliding = strength.rule == nullptr ? slide_linearly(trial, spring, at, {slip})
                                                     : slide_by_rule(trial, spring, at, {slip});
    const double  x = sliding.slip.added, slope = sliding.fall;
    r.shear             = std::copysign(std::abs(trial) - spring * x, trial);
    r.history.softening = slip.before + x;
    r.state             = ContactState::sliding;

    r.shear_by_slip                 = -slope * spring / (spring - slope);
    const SoftenedStrength softened = strength.after(sliding.slip);
    const double           by_gap   = r.shear == 0. ? 0.
                                                    : softened.tan_phi * r.k_nn + at.cohesion_by_gap +
                                            softened.cohesion * at.damage_by_gap;
    r.k_tn                          = std::copysign(spring / (spring - slope) * by_gap, trial);
  }
} // namespace hybrid::dda
