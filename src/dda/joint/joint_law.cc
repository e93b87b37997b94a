// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/joint_slide.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybrid::dda
{
  JointLaw::CohesionTaper JointLaw::cohesion_taper(const double damage,
                                                   const double residual_cohesion) const
  {
    if (!std::isfinite(residual_cohesion))
      return {0., 0.};
    const double contact = residual_cohesion / k_n;
    if (damage >= 1.)
      return {0., contact};
    const double elastic = strength.tensile / k_n;
    return {elastic, std::max(tension().critical_opening(), elastic + contact)};
  }



  double JointLaw::parting_opening() const
  {
    return cohesion_taper(0., strength.residual_cohesion).end;
  }



  double JointLaw::widest_opening(const double gap, const JointHistory &history) const
  {
    if (!strength.opening_ends_cohesion || history.damage <= 0.)
      return gap;
    return std::max(gap, tension().largest_opening(history.damage));
  }



  JointResponse JointLaw::respond(const JointKinematics &kinematics,
                                  const JointHistory    &history,
                                  const JointDamping    &damping) const
  {
    return respond(kinematics, history, damping, Held::nothing);
  }



  JointResponse JointLaw::respond_locked(const JointKinematics &kinematics,
                                         const JointHistory    &history,
                                         const JointDamping    &damping) const
  {
    return respond(kinematics, history, damping, Held::slip);
  }



  JointResponse JointLaw::respond_whole(const JointKinematics &kinematics,
                                        const JointHistory    &history,
                                        const JointDamping    &damping) const
  {
    return respond(kinematics, history, damping, Held::slip_and_opening);
  }



  JointResponse JointLaw::respond(const JointKinematics &kinematics,
                                  const JointHistory    &history,
                                  const JointDamping    &damping,
                                  const Held             held) const
  {
    JointResponse r;
    r.history = history;
    normal_response(kinematics.gap, held != Held::slip_and_opening, r);
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
      at.damage_by_gap = tension().damage_by_gap(kinematics.gap);
    const double widest = widest_opening(kinematics.gap, history);
    if (widest > fade.begin && fade.end > 0.)
      {
        const double left = std::max(0., (fade.end - widest) / (fade.end - fade.begin));
        at.residual_cohesion *= left;
        if (left > 0. && widest == kinematics.gap)
          at.cohesion_by_gap = residual_cohesion / (fade.end - fade.begin);
      }
    const PlasticSlip slip{history.softening, 0., kinematics.duration};
    r.mohr_coulomb =
      mohr_coulomb(at,
                   strength.rule == nullptr ? strength.after_linear(history.softening)
                                            : strength.after(slip));
    const double limit = std::max(0., r.mohr_coulomb);
    if (held == Held::nothing && std::abs(trial) > limit)
      {
        slide(trial, spring, at, slip, r);
        r.history.plastic_slip = kinematics.slip + r.shear / spring - shift;
        r.shear_strength       = std::abs(r.shear);
      }
    else
      {
        r.shear          = trial;
        r.shear_strength = limit;
        r.shear_by_slip  = spring;
        r.state          = ContactState::locked;
      }
    r.elastic_shear = -k_s * (kinematics.slip - r.history.plastic_slip);

    return r;
  }



  bool JointLaw::is_coulomb(const JointHistory &history, const double cohesion_length_ratio) const
  {
    const bool gone =
      cohesion_length_ratio == 0. || (strength.opening_ends_cohesion && history.damage >= 1.);
    const double c     = gone ? 0. : strength.residual_cohesion;
    const bool   fixed = strength.tan_phi == strength.residual_tan_phi ||
                       std::isinf(strength.softening_slip) ||
                       (history.softening > 0. && history.softening >= strength.softening_slip);
    return strength.rule == nullptr && (c == 0. || std::isinf(c)) &&
           (std::isinf(c) || (fixed && (history.damage >= 1. || strength.tensile == 0.)));
  }



  double JointLaw::friction(const JointHistory &history) const
  {
    return std::isinf(strength.residual_cohesion) ? strength.residual_cohesion
                                                  : strength.friction_at(history.softening);
  }



  JointResponse JointLaw::respond_in(const Condition        condition,
                                     const JointKinematics &kinematics,
                                     const JointHistory    &history,
                                     const JointDamping    &damping) const
  {
    JointResponse r;
    r.history = history;
    if (condition == Condition::open)
      {
        r.history.plastic_slip = kinematics.slip;
        return r;
      }
    r.normal = r.elastic_normal = -k_n * kinematics.gap;
    r.k_nn                      = k_n;
    const double spring         = (1. + damping.ratio) * k_s;
    const double shift          = damping.ratio / (1. + damping.ratio) * damping.elastic_slip;
    if (condition == Condition::sticks)
      {
        r.shear         = -spring * (kinematics.slip - history.plastic_slip - shift);
        r.shear_by_slip = spring;
        r.state         = ContactState::locked;
      }
    else
      {
        const double sign      = condition == Condition::slides_forward ? 1. : -1.;
        r.shear                = sign * friction(history) * r.normal;
        r.k_tn                 = sign * friction(history) * k_n;
        r.history.plastic_slip = kinematics.slip + r.shear / spring - shift;
        r.state                = ContactState::sliding;
      }
    r.elastic_shear  = -k_s * (kinematics.slip - r.history.plastic_slip);
    r.shear_strength = std::abs(r.shear);
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
    const double limit = -tension().tensile_strength(r.history.damage);
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



  void JointLaw::normal_response(const double gap, const bool may_crack, JointResponse &r) const
  {
    if (gap > 0.)
      {
        const double damage = may_crack ? tension().damage_at(gap) : 0.;
        const bool   cracks = damage > r.history.damage;
        r.history.damage    = std::max(r.history.damage, damage);
        const double secant = (1. - r.history.damage) * k_n;
        r.normal            = secant == 0. ? 0. : -secant * gap;
        if (!cracks)
          r.k_nn = secant;
        else if (damage < 1.)
          r.k_nn = -strength.tensile / (tension().critical_opening() - strength.tensile / k_n);
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
    const double before =
      history.held > 0. ? history.held : tension().tensile_strength(history.damage);
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



  double JointLaw::stored_energy(const JointKinematics &kinematics,
                                 const JointHistory    &history) const
  {
    const double k = kinematics.gap > 0. ? (1. - history.damage) * k_n : k_n;
    const double e = kinematics.slip - history.plastic_slip;
    return 0.5 * k * kinematics.gap * kinematics.gap + 0.5 * k_s * e * e;
  }



  double JointLaw::fracture_loss(const JointHistory &history) const
  {
    return tension().loss(history.damage);
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
    return history.held > 0. ? std::min(history.damage, tension().damage_at_tension(history.held))
                             : history.damage;
  }



  bool JointLaw::broken_in_shear(const JointHistory &history) const
  {
    return history.softening > 0. && history.softening >= strength.softening_slip;
  }



  bool JointLaw::loses_by_failing(const bool is_torn) const
  {
    const double left = is_torn ? 0. : strength.residual_cohesion;
    return strength.tensile > 0. || left < strength.cohesion ||
           strength.residual_tan_phi < strength.tan_phi;
  }
} // namespace hybrid::dda
