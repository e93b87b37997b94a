// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/joint_law.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybrid::dda
{
  namespace
  {
    double tan_deg(const double angle)
    {
      return std::tan(angle * M_PI / 180.);
    }
  } // namespace



  JointStrength JointStrength::bond(const Material &material,
                                    const double    fracture_energy,
                                    const double    softening_slip)
  {
    JointStrength s;
    s.tensile           = material.tensile_strength;
    s.cohesion          = material.cohesion;
    s.tan_phi           = tan_deg(material.friction_angle);
    s.residual_cohesion = std::max(0., material.residual_cohesion);
    s.residual_tan_phi =
      material.residual_friction_angle < 0. ? s.tan_phi : tan_deg(material.residual_friction_angle);
    s.fracture_energy = fracture_energy;
    s.softening_slip  = softening_slip;
    return s;
  }



  JointStrength JointStrength::belt(const Material &material,
                                    const double    fracture_energy,
                                    const double    softening_slip)
  {
    JointStrength s = bond(material, fracture_energy, softening_slip);
    if (material.residual_cohesion < 0.)
      s.residual_cohesion = s.cohesion;
    s.opening_ends_cohesion = true;
    return s;
  }



  JointStrength JointStrength::unlimited_bond()
  {
    JointStrength s = unlimited_friction();
    s.tensile       = std::numeric_limits<double>::infinity();
    return s;
  }



  JointStrength JointStrength::unlimited_friction()
  {
    JointStrength s;
    s.cohesion = s.residual_cohesion = std::numeric_limits<double>::infinity();
    return s;
  }



  JointStrength JointStrength::bedding_plane(const scene::BeddingParameters &bedding)
  {
    JointStrength s;
    s.cohesion = bedding.cohesion;
    s.tan_phi = s.residual_tan_phi = tan_deg(bedding.friction_angle);
    s.tensile        = s.tan_phi > 0. ? std::min(bedding.tensile_strength, s.cohesion / s.tan_phi)
                                      : bedding.tensile_strength;
    s.softening_slip = std::numeric_limits<double>::infinity();
    return s;
  }



  JointStrength JointStrength::roller()
  {
    JointStrength s;
    s.tensile = std::numeric_limits<double>::infinity();
    return s;
  }



  JointStrength JointStrength::residual(const Material &material)
  {
    JointStrength s = bond(material, 0., 0.);
    s.tensile       = 0.;
    s.cohesion      = s.residual_cohesion;
    s.tan_phi       = s.residual_tan_phi;
    return s;
  }



  JointStrength JointStrength::weaker_of(const JointStrength &other) const
  {
    JointStrength s = *this;
    s.tan_phi = s.residual_tan_phi = std::min(residual_tan_phi, other.residual_tan_phi);
    s.cohesion = s.residual_cohesion = std::min(residual_cohesion, other.residual_cohesion);
    return s;
  }



  JointStrength JointStrength::broken_belt(const Material &material)
  {
    JointStrength s     = residual(material);
    s.residual_cohesion = belt(material, 0., 0.).residual_cohesion;
    s.cohesion          = s.residual_cohesion;
    return s;
  }



  double JointLaw::critical_opening() const
  {
    return strength.tensile > 0. ? 2. * strength.fracture_energy / strength.tensile : 0.;
  }



  double JointLaw::friction_at(const double softening) const
  {
    return strength.tan_phi +
           (strength.residual_tan_phi - strength.tan_phi) * softened_fraction(softening);
  }



  double JointLaw::softened_fraction(const double softening) const
  {
    if (strength.softening_slip > 0.)
      return std::min(softening / strength.softening_slip, 1.);
    return softening > 0. ? 1. : 0.;
  }



  double JointLaw::damage_at(const double gap) const
  {
    const double elastic = strength.tensile / k_n; // opening at the tensile strength
    if (gap <= elastic)
      return 0.;
    const double critical = critical_opening();
    if (gap >= critical || critical <= elastic)
      return 1.;
    return 1. - elastic * (critical - gap) / (gap * (critical - elastic));
  }



  double JointLaw::damage_by_gap(const double gap) const
  {
    const double elastic = strength.tensile / k_n, critical = critical_opening();
    if (gap <= elastic || gap >= critical)
      return 0.;
    return elastic * critical / (gap * gap * (critical - elastic));
  }



  double JointLaw::largest_opening(const double damage) const
  {
    const double elastic  = strength.tensile / k_n;
    const double critical = std::max(elastic, critical_opening());
    // The linear softening branch has this damage where g = a g_c / (1 - D + a).
    const double a = elastic / std::max(critical - elastic, 1e-300);
    return std::min(critical, a * critical / (1. - damage + a));
  }



  double JointLaw::tensile_strength(const double damage) const
  {
    return damage > 0. ? (1. - damage) * k_n * largest_opening(damage) : strength.tensile;
  }



  JointLaw::CohesionTaper JointLaw::cohesion_taper(const double damage,
                                                   const double residual_cohesion) const
  {
    if (!std::isfinite(residual_cohesion))
      return {0., 0.};
    const double contact = residual_cohesion / k_n;
    if (damage >= 1.)
      return {0., contact};
    const double elastic = strength.tensile / k_n;
    return {elastic, std::max(critical_opening(), elastic + contact)};
  }



  double JointLaw::parting_opening() const
  {
    return cohesion_taper(0., strength.residual_cohesion).end;
  }



  double JointLaw::widest_opening(const double gap, const JointHistory &history) const
  {
    if (!strength.opening_ends_cohesion || history.damage <= 0.)
      return gap;
    return std::max(gap, largest_opening(history.damage));
  }



  double JointLaw::bond_cohesion(const double softening) const
  {
    if (strength.cohesion == strength.residual_cohesion) // infinite, perhaps
      return 0.;
    return (strength.cohesion - strength.residual_cohesion) * (1. - softened_fraction(softening));
  }



  double JointLaw::shear_strength(const Strain &at, const double softening) const
  {
    const double bond = bond_cohesion(softening) * (1. - at.damage);
    return std::max(0., bond + at.residual_cohesion + at.normal * friction_at(softening));
  }



  JointResponse JointLaw::respond(const JointKinematics &kinematics,
                                  const JointHistory    &history,
                                  const JointDamping    &damping) const
  {
    return respond(kinematics, history, damping, false);
  }



  JointResponse JointLaw::respond_locked(const JointKinematics &kinematics,
                                         const JointHistory    &history,
                                         const JointDamping    &damping) const
  {
    return respond(kinematics, history, damping, true);
  }



  JointResponse JointLaw::respond(const JointKinematics &kinematics,
                                  const JointHistory    &history,
                                  const JointDamping    &damping,
                                  const bool             sticks) const
  {
    JointResponse r;
    r.history = history;
    normal_response(kinematics.gap, r);
    hold(kinematics, history, r);
    const double left_by_opening = strength.opening_ends_cohesion && history.damage >= 1. ? 0. : 1.;
    const double residual_cohesion =
      left_by_opening * kinematics.cohesion_length_ratio * strength.residual_cohesion;
    const CohesionTaper fade = cohesion_taper(r.history.damage, residual_cohesion);
    if (kinematics.gap > 0. && kinematics.gap >= fade.end && has_let_go(r.history))
      {
        // Open for good: no shear; the friction spring starts from zero on closing.
        r.history.plastic_slip = kinematics.slip;
        r.state                = ContactState::open;
        return r;
      }

    const double dashpot = damping.ratio * (1. - r.history.damage) * k_n;
    const double viscous = -dashpot * (kinematics.gap - damping.gap);
    if (viscous < 0.)
      resist_opening(viscous, dashpot, r.history.damage > history.damage, r);
    else
      {
        r.normal += viscous;
        r.k_nn += dashpot;
      }

    // Spring and dashpot of the step together: a stiffer spring from a shifted origin. Friction
    // counts the normal traction that acts, that of the dashpot included.
    const double spring = (1. + damping.ratio) * k_s;
    const double shift  = damping.ratio / (1. + damping.ratio) * damping.elastic_slip;
    const double trial  = -spring * (kinematics.slip - history.plastic_slip - shift);
    Strain       at{r.normal, contact_fraction(r.history), residual_cohesion, 0., 0.};
    if (r.history.damage > history.damage && at.damage == r.history.damage)
      at.damage_by_gap = damage_by_gap(kinematics.gap);
    const double widest = widest_opening(kinematics.gap, history);
    if (widest > fade.begin && fade.end > 0.)
      {
        const double left = std::max(0., (fade.end - widest) / (fade.end - fade.begin));
        at.residual_cohesion *= left;
        if (left > 0. && widest == kinematics.gap)
          at.cohesion_by_gap = residual_cohesion / (fade.end - fade.begin);
      }
    if (!sticks && std::abs(trial) > shear_strength(at, history.softening))
      {
        slide(trial, spring, at, r);
        r.history.plastic_slip = kinematics.slip + r.shear / spring - shift;
      }
    else
      {
        r.shear         = trial;
        r.shear_by_slip = spring;
        r.state         = ContactState::locked;
      }
    r.elastic_shear = -k_s * (kinematics.slip - r.history.plastic_slip);

    return r;
  }



  void JointLaw::resist_opening(const double   viscous,
                                const double   dashpot,
                                const bool     cracks,
                                JointResponse &r) const
  {
    // While it cracks the spring alone takes all that the bond can bear.
    if (cracks)
      return;
    const double limit = -tensile_strength(r.history.damage);
    if (r.elastic_normal + viscous >= limit)
      {
        r.normal += viscous;
        r.k_nn += dashpot;
      }
    else if (r.elastic_normal > limit)
      {
        r.normal = limit;
        r.k_nn   = 0.;
      }
  }



  void JointLaw::normal_response(const double gap, JointResponse &r) const
  {
    if (gap > 0.)
      {
        const double damage = damage_at(gap);
        const bool   cracks = damage > r.history.damage;
        r.history.damage    = std::max(r.history.damage, damage);
        const double secant = (1. - r.history.damage) * k_n;
        r.normal            = secant == 0. ? 0. : -secant * gap;
        if (!cracks)
          r.k_nn = secant;
        else if (damage < 1.)
          r.k_nn = -strength.tensile / (critical_opening() - strength.tensile / k_n);
      }
    else
      {
        r.normal = -k_n * gap;
        r.k_nn   = k_n;
      }
    r.elastic_normal = r.normal;
  }



  void JointLaw::hold(const JointKinematics &kinematics,
                      const JointHistory    &history,
                      JointResponse         &r) const
  {
    r.history.held = 0.;
    if (release_time <= 0. || (history.held <= 0. && r.history.damage <= history.damage))
      return;
    const double before  = history.held > 0. ? history.held : tensile_strength(history.damage);
    const double left    = before - strength.tensile * kinematics.duration / release_time;
    const double tension = std::min(left, k_n * kinematics.gap);
    if (left <= 0. || (kinematics.gap > 0. && tension <= -r.normal))
      return;
    r.history.held = left;
    if (kinematics.gap > 0.)
      {
        r.normal = -tension;
        r.k_nn   = tension < left ? k_n : 0.;
      }
  }



  void
  JointLaw::slide(const double trial, const double spring, const Strain &at, JointResponse &r) const
  {
    // Strength and spring both fall linearly with the slip increment x,
    //   |trial| - spring x = strength(kappa + x), strength piecewise linear in x.
    const double kappa = r.history.softening;
    const double now   = shear_strength(at, kappa);
    const double end   = std::isfinite(strength.softening_slip)
                           ? shear_strength(at, kappa + strength.softening_slip + 1.)
                           : now;                          // residual
    double       x     = (std::abs(trial) - end) / spring; // residual strength reached
    double       slope = 0.;
    const double left  = std::max(0., strength.softening_slip - kappa);
    if (left > 0. && x < left)
      {
        slope = (now - end) / left; // fall of strength per slip
        if (slope < spring)
          x = std::max(0., std::min((std::abs(trial) - now) / (spring - slope), left));
        else
          slope = 0.; // brittle: straight to the residual
      }
    r.shear             = std::copysign(std::abs(trial) - spring * x, trial);
    r.history.softening = kappa + x;
    r.state             = ContactState::sliding;

    r.shear_by_slip     = -slope * spring / (spring - slope);
    const double by_gap = r.shear == 0.
                            ? 0.
                            : friction_at(r.history.softening) * r.k_nn + at.cohesion_by_gap +
                                bond_cohesion(r.history.softening) * at.damage_by_gap;
    r.k_tn              = std::copysign(spring / (spring - slope) * by_gap, trial);
  }



  double JointLaw::stored_energy(const JointKinematics &kinematics,
                                 const JointHistory    &history) const
  {
    const double k = kinematics.gap > 0. ? (1. - history.damage) * k_n : k_n;
    const double e = kinematics.slip - history.plastic_slip;
    return 0.5 * k * kinematics.gap * kinematics.gap + 0.5 * k_s * e * e;
  }



  double JointLaw::fracture_loss(const JointHistory &history) const
  {
    if (history.damage <= 0. || strength.tensile <= 0.)
      return 0.;
    const double elastic  = strength.tensile / k_n;
    const double gap      = largest_opening(history.damage);
    const double traction = (1. - history.damage) * k_n * gap;
    return 0.5 * strength.tensile * elastic +
           0.5 * (strength.tensile + traction) * (gap - elastic) - 0.5 * traction * gap;
  }



  bool JointLaw::has_residual_cohesion() const
  {
    return strength.residual_cohesion > 0. && std::isfinite(strength.residual_cohesion);
  }



  bool JointLaw::broken_in_tension(const JointHistory &history) const
  {
    return history.damage >= 1.;
  }



  bool JointLaw::has_let_go(const JointHistory &history) const
  {
    return history.damage >= 1. && history.held <= 0.;
  }



  double JointLaw::contact_fraction(const JointHistory &history) const
  {
    return history.held > 0. ? std::min(history.damage, 1. - history.held / strength.tensile)
                             : history.damage;
  }



  bool JointLaw::broken_in_shear(const JointHistory &history) const
  {
    return history.softening > 0. && history.softening >= strength.softening_slip;
  }
} // namespace hybrid::dda
