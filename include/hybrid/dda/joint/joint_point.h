// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/contact_state.h>

#include <limits>

/**
 * @file
 * What a joint law is asked and what it answers, at one point of a joint or contact.
 */
namespace hybrid::dda
{
  /// Relative displacement of the two sides at one point of a joint or contact.
  struct JointKinematics
  {
    double gap;  ///< g [m], positive when open
    double slip; ///< s [m] along the tangent, since the joint was made

    /// Length on which the residual cohesion acts over that of the springs [-] (of contacts).
    double cohesion_length_ratio = 1.;

    /// Of the step that led there [s].
    double duration = std::numeric_limits<double>::infinity();
  };


  /// What a joint point remembers.
  struct JointHistory
  {
    double plastic_slip = 0.; ///< s_p [m]: shear traction = -k_s (s - s_p)
    double softening    = 0.; ///< kappa [m]: sum of |d s_p| so far
    double damage       = 0.; ///< D of the tensile bond [-], 0 intact, 1 broken
    double held         = 0.; ///< tension that a bond bears still while it lets go [Pa]
  };


  /**
   * Stiffness-proportional damping of a joint's springs over one step, by
   * backward differences: the springs act with their elastic stretch plus
   * beta_K / dt of its change. The slider is in series with spring and dashpot,
   * so the traction is continuous where sticking turns into slip. Likewise the
   * tension of spring and dashpot together is never above the tensile strength
   * that damage has left: the dashpot bears what the spring leaves of it.
   * Damage follows the opening alone, so the fracture energy is that of the law
   * at any rate.
   */
  struct JointDamping
  {
    double ratio        = 0.; ///< beta_K / dt [-]; 0: none
    double gap          = 0.; ///< when the step began [m]
    double elastic_slip = 0.; ///< s - s_p when the step began [m]
  };


  /// Tractions of a joint point and the tangent that the iteration uses.
  struct JointResponse
  {
    double normal         = 0.; ///< total [Pa], compression positive
    double shear          = 0.; ///< total [Pa], opposes the elastic slip
    double elastic_normal = 0.; ///< without damping [Pa]
    double elastic_shear  = 0.; ///< without damping [Pa]
    double shear_strength = 0.; ///< that the shear may reach now [Pa]
    double mohr_coulomb   = 0.; ///< c + N tan(phi) after the slip, negative beyond the apex [Pa]
    double k_nn           = 0.; ///< tangent -dN/dg [Pa/m]; negative on the softening branch
    double shear_by_slip  = 0.; ///< tangent -dT/ds [Pa/m]; negative while the strength falls
    double k_tn           = 0.; ///< tangent -dT/dg [Pa/m]: friction follows the normal force
    ContactState state    = ContactState::open;
    JointHistory history; ///< what is remembered if the step is accepted
  };
} // namespace hybrid::dda
