// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/belt_bond.h>
#include <hybrid/dda/joint/rate_belt.h>

#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    /// Friction that softens with slip and follows its rate.
    SoftenedStrength rated(const JointStrength &s, const PlasticSlip &slip)
    {
      const double     kappa    = slip.before + slip.added;
      const bool       falls    = s.softening_slip > 0. && kappa < s.softening_slip;
      const double     per_slip = falls ? 1. / s.softening_slip : 0.;
      const double     rate     = slip.added / slip.duration / s.reference_rate; // over v_0
      const RateFactor factor   = rate_factor(s.rate_coefficient, std::log1p(rate));
      const double     slow     = s.friction_at(kappa);
      const double     bond =
        s.cohesion == s.residual_cohesion ? 0. : (s.residual_cohesion - s.cohesion) * per_slip;
      return {slow * factor.value,
              s.bond_cohesion(kappa),
              (s.residual_tan_phi - s.tan_phi) * per_slip * factor.value +
                slow * factor.derivative / ((1. + rate) * slip.duration * s.reference_rate),
              bond};
    }



    JointStrength with_rate(JointStrength strength, const Material &material)
    {
      if (!material.has_rate_effect())
        return strength;
      strength.rate_coefficient = material.rate_coefficient;
      strength.reference_rate   = material.reference_rate;
      strength.rule             = rated;
      return strength;
    }



    JointStrength
    bonded(const Material &material, const double fracture_energy, const double softening_slip)
    {
      return with_rate(belt_strength(material, fracture_energy, softening_slip), material);
    }



    JointStrength broken(const Material &material)
    {
      return with_rate(broken_belt_strength(material), material);
    }
  } // namespace



  RateFactor rate_factor(const double coefficient, const double logarithm)
  {
    const double effect = coefficient * logarithm;
    if (coefficient >= 0.)
      return {1. + effect, coefficient};
    return {1. / (1. - effect), coefficient / ((1. - effect) * (1. - effect))};
  }



  BondLaw rate_belt()
  {
    return {"rate belt", bonded, broken};
  }
} // namespace hybrid::dda
