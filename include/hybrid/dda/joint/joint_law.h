// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/contact_state.h>
#include <hybrid/scene/material.h>

#include <limits>

namespace hybrid::scene
{
  struct BeddingParameters;
}

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
    double       normal         = 0.; ///< total [Pa], compression positive
    double       shear          = 0.; ///< total [Pa], opposes the elastic slip
    double       elastic_normal = 0.; ///< without damping [Pa]
    double       elastic_shear  = 0.; ///< without damping [Pa]
    double       k_nn           = 0.; ///< tangent -dN/dg [Pa/m]; negative on the softening branch
    double       shear_by_slip  = 0.; ///< tangent -dT/ds [Pa/m]; negative while the strength falls
    double       k_tn           = 0.; ///< tangent -dT/dg [Pa/m]: friction follows the normal force
    ContactState state          = ContactState::open;
    JointHistory history; ///< what is remembered if the step is accepted
  };


  /// Strength of a joint; angles as tangents.
  struct JointStrength
  {
    double tensile           = 0.;      ///< F_t [Pa]
    double cohesion          = 0.;      ///< c [Pa]
    double tan_phi           = 0.;      ///< tan of the friction angle [-]
    double residual_cohesion = 0.;      ///< c_res [Pa]
    double residual_tan_phi  = 0.;      ///< tan of the residual friction angle [-]
    double fracture_energy   = 0.;      ///< G_f [J/m2]; 0: brittle
    double softening_slip    = 0.;      ///< slip from peak to residual strength [m]; 0: brittle;
                                        ///< infinity: slip takes nothing
    bool opening_ends_cohesion = false; ///< opening takes the residual cohesion, too, for good

    /// Bond between blocks of a material: peak strength, residual as the material says, else
    /// friction only.
    static JointStrength
    bond(const Material &material, double fracture_energy, double softening_slip);

    /// Bond of a sliding belt, an old shear zone: residual as the material says, else as the peak.
    /// Opening takes all cohesion for good, as on bedding planes.
    static JointStrength
    belt(const Material &material, double fracture_energy, double softening_slip);

    /// Bond that neither breaks nor slips.
    static JointStrength unlimited_bond();

    /// Contact that opens freely but never slips.
    static JointStrength unlimited_friction();

    /// Bedding plane: Mohr-Coulomb with tension cut-off. Slip takes nothing of the strength; an end
    /// that opens beyond the cut-off (at most c / tan phi) keeps its friction only.
    static JointStrength bedding_plane(const scene::BeddingParameters &bedding);

    /// Two sides that may slide on each other but not part.
    static JointStrength roller();

    /// Of this and another contact the smaller residual friction, and the smaller cohesion.
    JointStrength weaker_of(const JointStrength &other) const;

    /// Contact without any bond: residual strength only.
    static JointStrength residual(const Material &material);

    /// Contact on a belt: its residual strength, the cohesion on the area that is bonded still.
    static JointStrength broken_belt(const Material &material);
  };


  /**
   * Mohr-Coulomb joint that cracks and softens.
   *
   * Opening: elastic up to F_t, then linear softening of the traction to zero
   * at the critical opening g_c = 2 G_f / F_t (the area under the whole curve
   * is G_f; brittle if g_c <= F_t / k_n); unloading to the origin with the
   * secant stiffness (1 - D) k_n. Closing is always elastic with k_n.
   *
   * Shear: elastic with k_s up to c + N tan(phi) (N compression positive,
   * never below zero), then plastic slip; with kappa, the sum of plastic slip,
   * cohesion and friction fall linearly to their residual over the softening
   * slip. Tensile damage takes the part (1 - D) of the cohesion that is above
   * its residual. The residual cohesion of a contact, taken per length of its
   * springs, fades while it opens, over c_res / k_n; that of a bond from
   * F_t / k_n on, to g_c if that is later: if it vanished at once, a joint that
   * is about to open might have no equilibrium. What has faded from a belt never comes back.
   *
   * Letting go: a bond of letting_go_in(t_r) never loses tension faster than F_t / t_r, and
   * cohesion in step with it. What it bears beyond its softening is JointHistory::held, a slider of
   * falling strength behind the spring k_n; its work counts as damping.
   *
   * A law is a pure function: history is an argument and a result, so the
   * open-close iteration may ask as often as it likes. The tangent is
   * consistent, so it is unsymmetric while the joint slides with friction: with
   * lagged friction the static stage of a slope near its limit did not settle.
   */
  class JointLaw
  {
  public:
    /// @param normal_spring k_n [Pa/m], > 0.  @param shear_spring k_s [Pa/m], > 0.
    JointLaw(const JointStrength &joint_strength, double normal_spring, double shear_spring)
      : strength(joint_strength)
      , k_n(normal_spring)
      , k_s(shear_spring)
    {}

    JointResponse respond(const JointKinematics &kinematics,
                          const JointHistory    &history,
                          const JointDamping    &damping = {}) const;

    /// What the point would bear if it stuck whatever its shear strength.
    JointResponse respond_locked(const JointKinematics &kinematics,
                                 const JointHistory    &history,
                                 const JointDamping    &damping = {}) const;

    /// Opening from which an intact bond bears nothing any more [m].
    double parting_opening() const;

    /// The same without loss of strength by slip.
    JointLaw without_softening() const
    {
      JointLaw law                = *this;
      law.strength.softening_slip = std::numeric_limits<double>::infinity();
      return law;
    }

    /// The same, with a tension that takes this time to fall by F_t [s].
    JointLaw letting_go_in(const double time) const
    {
      JointLaw law     = *this;
      law.release_time = time;
      return law;
    }

    /// The same springs with another strength.
    JointLaw with(const JointStrength &other) const
    {
      return {other, k_n, k_s};
    }

    /// k_n [Pa/m]
    double normal_stiffness() const
    {
      return k_n;
    }

    /// k_s [Pa/m]
    double shear_stiffness() const
    {
      return k_s;
    }

    /// True if a contact carries cohesion, and a limited one.
    bool has_residual_cohesion() const;

    /// Energy stored in the springs per area [J/m2].
    double stored_energy(const JointKinematics &kinematics, const JointHistory &history) const;

    /// Energy that tensile damage has consumed per area so far [J/m2], from 0 to G_f.
    double fracture_loss(const JointHistory &history) const;

    /// True if the bond is gone: tensile damage complete.
    bool broken_in_tension(const JointHistory &history) const;

    /// True if the bond is gone and has let go.
    bool has_let_go(const JointHistory &history) const;

    /// Part that is torn and has let go, and acts as a contact from then on [-].
    double contact_fraction(const JointHistory &history) const;

    /// True if the shear strength is at its residual.
    bool broken_in_shear(const JointHistory &history) const;

  private:
    JointStrength strength;
    double        k_n;               ///< [Pa/m]
    double        k_s;               ///< [Pa/m]
    double        release_time = 0.; ///< t_r [s]

    /// @param sticks its shear strength is not asked for.
    JointResponse respond(const JointKinematics &kinematics,
                          const JointHistory    &history,
                          const JointDamping    &damping,
                          bool                   sticks) const;

    /// Opening at which no traction is left [m]; 0 without tensile strength.
    double critical_opening() const;

    /// Tan of the friction angle after the plastic slip @p softening [-].
    double friction_at(double softening) const;

    /// Part of the way from peak to residual strength, 0..1 [-].
    double softened_fraction(double softening) const;

    double damage_at(double gap) const;

    /// Derivative of damage_at().
    double damage_by_gap(double gap) const;

    /// Opening of the softening branch at which the bond had got this damage [m].
    double largest_opening(double damage) const;

    /// Tension that a bond with this damage bears [Pa]: F_t, or what is left of it.
    double tensile_strength(double damage) const;

    /// Openings between which the residual cohesion fades [m].
    struct CohesionTaper
    {
      double begin, end;
    };

    CohesionTaper cohesion_taper(double damage, double residual_cohesion) const;

    /// The opening that the residual cohesion has faded by: the present one, or the largest so far
    /// where opening takes it for good [m].
    double widest_opening(double gap, const JointHistory &history) const;

    /// What the shear strength of a joint depends on beside its plastic slip.
    struct Strain
    {
      double normal;            ///< normal traction that acts [Pa]
      double damage;            ///< [-]
      double residual_cohesion; ///< at this gap [Pa]
      double cohesion_by_gap;   ///< its fall with the gap [Pa/m]
      double damage_by_gap;     ///< while it cracks [1/m]
    };

    /// Cohesion above its residual, without damage [Pa].
    double bond_cohesion(double softening) const;

    double shear_strength(const Strain &at, double softening) const;

    /// Normal traction, damage and normal tangent without damping.
    void normal_response(double gap, JointResponse &response) const;

    /// Let a bond that lets go bear what it holds still.
    void hold(const JointKinematics &kinematics,
              const JointHistory    &history,
              JointResponse         &response) const;

    /// Add what the dashpot bears while a joint opens: @p viscous < 0 [Pa], as far as the strength
    /// allows. @param dashpot its tangent [Pa/m]
    void resist_opening(double viscous, double dashpot, bool cracks, JointResponse &response) const;

    /// Shear of a joint whose trial traction exceeds its strength. @p spring with damping [Pa/m].
    void slide(double trial, double spring, const Strain &at, JointResponse &response) const;
  };
} // namespace hybrid::dda
