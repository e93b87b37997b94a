// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/joint_law.h>

#include <cmath>

/**
 * @file
 * Sliding by linear softening, inline in JointLaw::respond(), which every spring asks in every
 * trial.
 */
namespace hybrid::dda
{
  inline JointLaw::Sliding JointLaw::slide_linearly(const double  trial,
                                                    const double  spring,
                                                    const Strain &at,
                                                    Sliding       from) const
  {
    const double kappa = from.slip.before;
    const double now   = softened_strength(at, kappa);
    const double end   = std::isfinite(strength.softening_slip)
                           ? softened_strength(at, kappa + strength.softening_slip + 1.)
                           : now;                          // residual
    double       x     = (std::abs(trial) - end) / spring; // residual strength reached
    const double left  = std::max(0., strength.softening_slip - kappa);
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



  inline void JointLaw::slide(const double       trial,
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
    r.mohr_coulomb                  = mohr_coulomb(at, softened);
    const double by_gap             = r.shear == 0. ? 0.
                                                    : softened.tan_phi * r.k_nn + at.cohesion_by_gap +
                                            softened.cohesion * at.damage_by_gap;
    r.k_tn                          = std::copysign(spring / (spring - slope) * by_gap, trial);
  }
} // namespace hybrid::dda
