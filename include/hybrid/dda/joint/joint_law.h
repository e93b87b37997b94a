// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/joint_point.h>
#include <hybrid/dda/joint/joint_strength.h>
#include <hybrid/dda/joint/tension_softening.h>

#include <algorithm>
#include <limits>

namespace hybrid::dda
{
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
   * slip, or as the strength's own rule says (ShearRule). Tensile damage takes the part (1 - D) of
   * the cohesion that is above its residual. The residual cohesion of a contact, taken per length
   * of its springs, fades while it opens, over c_res / k_n; that of a bond from F_t / k_n on, to
   * g_c if that is later: if it vanished at once, a joint that is about to open might have no
   * equilibrium. What has faded from a belt never comes back.
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

    /// What the point would bear if it neither slid nor cracked, whatever its strength.
    JointResponse respond_whole(const JointKinematics &kinematics,
                                const JointHistory    &history,
                                const JointDamping    &damping = {}) const;

    /// What a torn or never bonded point would bear in this condition: linear in gap and slip.
    /// @pre is_coulomb() and @p condition is not Condition::law
    JointResponse respond_in(Condition              condition,
                             const JointKinematics &kinematics,
                             const JointHistory    &history,
                             const JointDamping    &damping = {}) const;

    /// True if a point that bears no tension has a friction that slip does not change, and no
    /// cohesion or an unlimited one. @param cohesion_length_ratio see JointKinematics [-]
    bool is_coulomb(const JointHistory &history, double cohesion_length_ratio) const;

    /// Tan of its friction angle now, infinite if it never slides [-].
    double friction(const JointHistory &history) const;

    /// Whether it has more than friction to lose.
    bool bonds() const
    {
      return strength.tensile > 0. || strength.cohesion > 0.;
    }

    /// F_t [Pa]
    double tensile_strength() const
    {
      return strength.tensile;
    }

    /// Opening from which an intact bond bears nothing any more [m].
    double parting_opening() const;

    /// The same without loss of strength by slip.
    JointLaw without_softening() const
    {
      JointLaw law                = *this;
      law.strength.softening_slip = std::numeric_limits<double>::infinity();
      return law;
    }

    /// The same without an effect of the rate of slip: that of rest.
    JointLaw without_rate_effect() const
    {
      JointLaw law                  = *this;
      law.strength.rate_coefficient = 0.;
      return law;
    }

    /// The same with a bond that no tension tears.
    JointLaw without_tensile_failure() const
    {
      JointLaw law         = *this;
      law.strength.tensile = std::numeric_limits<double>::infinity();
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

    /// True if friction falls with the rate of slip.
    bool weakens_with_rate() const
    {
      return strength.rate_coefficient < 0.;
    }

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

    /// False if a point that fails bears afterwards what it did before, as belts whose residual
    /// strength is their peak do that bear no tension. @param is_torn it opens, not slips
    bool loses_by_failing(bool is_torn) const;

  private:
    JointStrength strength;
    double        k_n;               ///< [Pa/m]
    double        k_s;               ///< [Pa/m]
    double        release_time = 0.; ///< t_r [s]

    /// What the strength is not asked for.
    enum class Held : char
    {
      nothing,
      slip,
      slip_and_opening
    };

    JointResponse respond(const JointKinematics &kinematics,
                          const JointHistory    &history,
                          const JointDamping    &damping,
                          Held                   held) const;

    TensionSoftening tension() const
    {
      return {strength.tensile, strength.fracture_energy, k_n};
    }

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

    /// c + N tan(phi), negative beyond the apex [Pa].
    static double mohr_coulomb(const Strain &at, const SoftenedStrength &softened)
    {
      const double bond = softened.cohesion * (1. - at.damage);
      return bond + at.residual_cohesion + at.normal * softened.tan_phi;
    }

    /// After linear softening.
    double softened_strength(const Strain &at, const double softening) const
    {
      return std::max(0., mohr_coulomb(at, strength.after_linear(softening)));
    }

    /// Normal traction, damage and normal tangent without damping.
    void normal_response(double gap, bool may_crack, JointResponse &response) const;

    /// Let a bond that lets go bear what it holds still.
    void hold(const JointKinematics &kinematics,
              const JointHistory    &history,
              JointResponse         &response) const;

    /// Add what the dashpot bears while a joint opens: @p viscous < 0 [Pa], as far as the strength
    /// allows. @param dashpot its tangent [Pa/m]
    void resist_opening(double viscous, double dashpot, bool cracks, JointResponse &response) const;

    /// A point slides where spring and strength agree, |trial| - spring x = strength(kappa + x).
    struct Sliding
    {
      PlasticSlip slip;      ///< of which x is added
      double      fall = 0.; ///< of the strength per slip there [Pa/m], below the spring
    };

    /// Linear softening: strength and spring both fall linearly, piece by piece.
    Sliding slide_linearly(double trial, double spring, const Strain &at, Sliding from) const;

    /// Any other rule.
    Sliding slide_by_rule(double trial, double spring, const Strain &at, Sliding from) const;

    /// Shear of a joint whose trial traction exceeds its strength. @p spring with damping [Pa/m].
    void slide(double             trial,
               double             spring,
               const Strain      &at,
               const PlasticSlip &slip,
               JointResponse     &response) const;
  };
} // namespace hybrid::dda
