// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace hybrid::dda
{
  struct JointStrength;


  /// Plastic slip of a joint point.
  struct PlasticSlip
  {
    double before;     ///< kappa when the step began [m]
    double added = 0.; ///< x >= 0 by the step [m]

    /// Of the step [s].
    double duration = std::numeric_limits<double>::infinity();
  };


  /// Friction and cohesion after some slip.
  struct SoftenedStrength
  {
    double tan_phi;               ///< [-]
    double cohesion;              ///< above the residual, without damage [Pa]
    double tan_phi_by_slip  = 0.; ///< by PlasticSlip::added [1/m]
    double cohesion_by_slip = 0.; ///< likewise [Pa/m]
  };


  /// How shear strength follows slip and its rate. Pure; it may keep what it needs in the strength
  /// only, as PlasticSlip is all that is remembered.
  using ShearRule = SoftenedStrength (*)(const JointStrength &strength, const PlasticSlip &slip);


  /// Strength of a joint; angles as tangents.
  struct JointStrength
  {
    double tensile           = 0.; ///< F_t [Pa]
    double cohesion          = 0.; ///< c [Pa]
    double tan_phi           = 0.; ///< tan of the friction angle [-]
    double residual_cohesion = 0.; ///< c_res [Pa]
    double residual_tan_phi  = 0.; ///< tan of the residual friction angle [-]
    double fracture_energy   = 0.; ///< G_f [J/m2]; 0: brittle
    double softening_slip    = 0.; ///< slip from peak to residual strength [m]; 0: brittle;
                                   ///< infinity: slip takes nothing
    bool      opening_ends_cohesion = false; ///< opening takes the residual cohesion, too, for good
    double    rate_coefficient      = 0.;    ///< a of rate_belt.h [-]
    double    reference_rate        = 1.;    ///< v_0 of it [m/s]
    ShearRule rule = nullptr;                ///< nullptr: linear softening, which has a closed form

    /// Bond that neither breaks nor slips.
    static JointStrength unlimited_bond();

    /// Contact that opens freely but never slips.
    static JointStrength unlimited_friction();

    /// Two sides that may slide on each other but not part.
    static JointStrength roller();

    /// Of this and another contact the smaller residual friction, and the smaller cohesion.
    JointStrength weaker_of(const JointStrength &other) const;

    /// Part of the way of linear softening from peak to residual strength, 0..1 [-].
    double softened_fraction(const double slip) const
    {
      if (softening_slip > 0.)
        return std::min(slip / softening_slip, 1.);
      return slip > 0. ? 1. : 0.;
    }

    /// Tan of the friction angle after linear softening [-].
    double friction_at(const double slip) const
    {
      return tan_phi + (residual_tan_phi - tan_phi) * softened_fraction(slip);
    }

    /// Cohesion above its residual after linear softening, without damage [Pa].
    double bond_cohesion(const double slip) const
    {
      if (cohesion == residual_cohesion) // infinite, perhaps
        return 0.;
      return (cohesion - residual_cohesion) * (1. - softened_fraction(slip));
    }

    /// By linear softening, without derivatives, which its closed form has no use for.
    SoftenedStrength after_linear(const double slip) const
    {
      return {friction_at(slip), bond_cohesion(slip)};
    }

    /// By the rule, or by linear softening.
    SoftenedStrength after(const PlasticSlip &slip) const
    {
      return rule != nullptr ? rule(*this, slip) : after_linear(slip.before + slip.added);
    }
  };
} // namespace hybrid::dda
