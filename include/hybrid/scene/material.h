// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid
{
  /// Isotropic linear elastic material with Mohr-Coulomb strength for the joints made of it.
  struct Material
  {
    std::string name;
    double      density = 2500.; ///< rho [kg/m3], > 0: inertia
    double      weight_density =
      -1.; ///< mass density that gravity acts on [kg/m3]; < 0: same as density
    double young_modulus           = 1e9;  ///< E [Pa], > 0
    double poisson_ratio           = 0.25; ///< nu [-], in (-1, 0.5)
    double friction_angle          = 30.;  ///< phi [deg], in [0, 90)
    double given_friction_angle    = -1.;  ///< what the user says of it [deg]; < 0: nothing
    double cohesion                = 0.;   ///< c [Pa], >= 0
    double dilation_angle          = 0.;   ///< psi of blocks that yield [deg], in [0, phi]
    double tensile_strength        = 0.;   ///< F_t [Pa], >= 0
    double residual_friction_angle = -1.;  ///< phi_res [deg]; < 0: same as friction_angle
    double residual_cohesion =
      -1.; ///< c_res [Pa]; < 0: none for joints of the mass, for a belt the same as cohesion

    double rate_coefficient = 0.;   ///< a of a belt's friction mu (1 + a ln(1 + v/v_0)) [-]
    double reference_rate   = 1e-6; ///< v_0 of it [m/s], > 0

    double initial_ratio = -1.; ///< K0 of Gravity/Initial stress [-], >= 0; < 0: elastic

    bool friction_is_given() const
    {
      return given_friction_angle >= 0.;
    }

    /// As a belt its friction depends on the rate of slip.
    bool has_rate_effect() const
    {
      return rate_coefficient != 0.;
    }

    /// Density that gravity acts on [kg/m3].
    double weighing_density() const
    {
      return weight_density < 0. ? density : weight_density;
    }

    /// Horizontal over vertical effective stress of level ground before the static stage [-].
    double lateral_ratio() const
    {
      return initial_ratio < 0. ? poisson_ratio / (1. - poisson_ratio) : initial_ratio;
    }

    /// Shear modulus G = E / (2 (1 + nu)) [Pa].
    double shear_modulus() const
    {
      return young_modulus / (2. * (1. + poisson_ratio));
    }

    /// Lame's first parameter lambda [Pa].
    double lame_lambda() const
    {
      return young_modulus * poisson_ratio / ((1. + poisson_ratio) * (1. - 2. * poisson_ratio));
    }

    /// Speed of plane-strain P waves [m/s].
    double p_wave_speed() const;

    /// Speed of S waves [m/s].
    double s_wave_speed() const;
  };
} // namespace hybrid
