// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/springs/interior_contacts.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  InteriorContacts::Point InteriorContacts::point(const Model   &model,
                                                  const Springs &springs,
                                                  const double   dt,
                                                  const int      number)
  {
    const Springs::Spring &spring  = springs.springs[number];
    const JointHistory    &history = spring.old.history;
    double                 ratio   = 0.;
    if (spring.joint >= 0)
      ratio = (model.joints[spring.joint].within_bedrock() ? model.bedrock_damping_time
                                                           : model.joint_damping_time) /
              dt;
    const double mu = spring.law->friction(history);
    Point        p;
    p.spring  = number;
    p.length  = spring.length;
    p.is_bond = !spring.coulomb;
    p.slides  = std::isfinite(mu);
    p.mu      = p.slides ? mu : 0.;
    p.k_n     = spring.law->normal_stiffness();
    p.k_s     = (1. + ratio) * spring.law->shear_stiffness();
    p.origin =
      history.plastic_slip + ratio / (1. + ratio) * (spring.old.slip - history.plastic_slip);
    return p;
  }



  bool InteriorContacts::may_begin(const Springs::Spring &spring, const Springs::Response &response)
  {
    if (spring.length <= 0.)
      return false;
    const double mu = spring.law->friction(spring.old.history);
    return spring.coulomb || (spring.joint >= 0 && response.now.state != ContactState::open &&
                              mu > 0. && std::isfinite(response.mohr_coulomb));
  }



  void InteriorContacts::begin(const Model   &model,
                               const Springs &springs,
                               const double   dt,
                               const double   energy,
                               const double   force)
  {
    constexpr double within_strength = 0.9; ///< part of it that the shear begins with at most
    constexpr double least_force     = 0.1; ///< of a contact that presses, over the mean
    points.clear();
    points.reserve(springs.n_at_work());
    for (std::size_t k = 0; k < springs.n_at_work(); ++k)
      {
        const std::size_t        s        = springs.at_work(k);
        const Springs::Spring   &spring   = springs.springs[s];
        const Springs::Response &response = springs.responses[s];
        if (!may_begin(spring, response))
          continue;
        Point        p     = point(model, springs, dt, static_cast<int>(s));
        const double least = energy / p.length, traction = force / p.length;
        const double pressed = p.is_bond ? response.mohr_coulomb / p.mu : spring.old.normal;
        Variables   &at      = p.at;
        // All products are the same: where it pressed the parting follows, else the force.
        at.normal  = std::max(pressed, least_force * traction);
        at.parting = least / at.normal;
        if (pressed <= 0.)
          {
            at.parting = std::max(at.parting, p.gap(response));
            at.normal  = least / at.parting;
          }
        at.shear = spring.old.shear;
        if (p.slides)
          {
            const double limit  = within_strength * p.mu * at.normal;
            at.shear            = std::max(-limit, std::min(limit, at.shear));
            p.strength_forward  = p.mu * at.normal - at.shear;
            p.strength_backward = p.mu * at.normal + at.shear;
            at.forward          = least / std::max(p.strength_forward, 1e-300);
            at.backward         = least / std::max(p.strength_backward, 1e-300);
            p.slides            = p.mu > 0.;
            if (!p.slides)
              p.k_s = 0.; // frictionless
          }
        points.push_back(p);
      }
  }



  double InteriorContacts::Point::gap(const Springs::Response &response) const
  {
    return is_bond ? -response.mohr_coulomb / (mu * k_n) : response.now.gap;
  }



  InteriorContacts::Products InteriorContacts::Point::products_after(const double fraction) const
  {
    Products now;
    if (!acts)
      return now;
    now.parting =
      (at.normal + fraction * direction.normal) * (at.parting + fraction * direction.parting);
    if (slides)
      {
        now.forward = (at.forward + fraction * direction.forward) *
                      (strength_forward + fraction * forward_change());
        now.backward = (at.backward + fraction * direction.backward) *
                       (strength_backward + fraction * backward_change());
      }
    return now;
  }



  double InteriorContacts::mean_product_after(const double fraction) const
  {
    double sum = 0.;
    int    n   = 0;
    for (const Point &p : points)
      {
        const Products now = p.products_after(fraction);
        sum += p.length * (now.parting + now.forward + now.backward);
        n += !p.acts ? 0 : p.slides ? 3 : 1;
      }
    return sum / std::max(n, 1);
  }



  void InteriorContacts::aim(const double target, const bool corrects)
  {
    constexpr double largest_correction = 5.; ///< of the products' mean
    const double     mean               = mean_product();
    for (Point &p : points)
      {
        const double bound = largest_correction * mean / p.length;
        const auto   less  = [&](const double correction) {
          return target / p.length -
                 (corrects ? std::max(-bound, std::min(bound, correction)) : 0.);
        };
        const Variables &d = p.direction;
        p.target.parting   = less(d.normal * d.parting);
        p.target.forward   = less(d.forward * p.forward_change());
        p.target.backward  = less(d.backward * p.backward_change());
      }
  }



  void InteriorContacts::Point::eliminate()
  {
    const double compliance = at.parting + at.normal / k_n;
    k_nn                    = at.normal / compliance;
    normal_part = (target.parting - at.normal * at.parting - at.normal * parting_left) / compliance;
    if (!slides)
      {
        k_tt       = k_s;
        k_tn       = 0.;
        shear_part = k_s > 0. ? -k_s * slip_left : -at.shear;
        return;
      }
    const double f = at.forward / strength_forward, b = at.backward / strength_backward;
    const double sum       = 1. / k_s + f + b;
    const double by_normal = mu * (f - b) / sum;
    k_tt                   = 1. / sum;
    k_tn                   = by_normal * k_nn;
    shear_part             = (-slip_left - (target.forward / strength_forward - at.forward) +
                  (target.backward / strength_backward - at.backward)) /
                   sum +
                 by_normal * normal_part;
  }



  void InteriorContacts::Point::follow(const double gap, const double slip)
  {
    direction.normal  = normal_part - k_nn * gap;
    direction.shear   = shear_part - k_tn * gap - k_tt * slip;
    direction.parting = gap + direction.normal / k_n + parting_left;
    if (!slides)
      return;
    direction.forward =
      (target.forward - at.forward * forward_change()) / strength_forward - at.forward;
    direction.backward =
      (target.backward - at.backward * backward_change()) / strength_backward - at.backward;
  }



  void InteriorContacts::Point::set_longest()
  {
    longest          = 1.;
    const auto limit = [this](const double value, const double change) {
      if (change < 0.)
        longest = std::min(longest, -value / change);
    };
    limit(at.normal, direction.normal);
    limit(at.parting, direction.parting);
    if (!slides)
      return;
    limit(at.forward, direction.forward);
    limit(at.backward, direction.backward);
    limit(strength_forward, forward_change());
    limit(strength_backward, backward_change());
  }



  void InteriorContacts::set_responses(const Trial &trial, Springs &springs)
  {
#pragma omp parallel for schedule(static) if (is_worth_sharing(points.size()))
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        Point             &p        = points[i];
        Springs::Response &response = springs.responses[p.spring];
        p.acts                      = !p.is_bond || response.now.state != ContactState::open;
        if (!p.acts)
          continue;
        p.gap_by_opening = p.is_bond ? response.k_nn / p.k_n : 1.;
        p.parting_left   = p.gap(response) + p.at.normal / p.k_n - p.at.parting;
        p.slip_left      = response.now.slip - p.origin + (p.k_s > 0. ? p.at.shear / p.k_s : 0.);
        if (p.slides)
          p.slip_left += p.at.forward - p.at.backward;
        p.eliminate();
        if (!p.is_bond)
          {
            response.now.normal = p.at.normal + p.normal_part;
            response.k_nn       = p.k_nn;
          }
        response.now.shear     = p.at.shear + p.shear_part;
        response.shear_by_slip = p.k_tt;
        response.k_tn          = p.k_tn * p.gap_by_opening;
        springs.set_forces(trial, p.spring);
      }
  }



  double InteriorContacts::follow(const Springs         &springs,
                                  const SpringStiffness &stiffness,
                                  const Eigen::VectorXd &update)
  {
    double longest = 1.;
#pragma omp parallel for schedule(static) \
  reduction(min                           \
            : longest) if (is_worth_sharing(points.size()))
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        Point &p = points[i];
        if (!p.acts)
          continue;
        const Vec2 moved = stiffness.displacement_jump(springs, p.spring, update);
        p.follow(p.gap_by_opening * moved[0], moved[1]);
        p.set_longest();
        longest = std::min(longest, p.longest);
      }
    return longest;
  }



  void InteriorContacts::Point::move(const double fraction)
  {
    at.normal += fraction * direction.normal;
    at.parting += fraction * direction.parting;
    at.shear += fraction * direction.shear;
    at.forward += fraction * direction.forward;
    at.backward += fraction * direction.backward;
    // Sums of small changes: mu N - T would be all round-off where the contact slides.
    strength_forward += fraction * forward_change();
    strength_backward += fraction * backward_change();
    direction = {};
  }



  void InteriorContacts::move(const double fraction)
  {
    for (Point &p : points)
      p.move(fraction);
  }



  void InteriorContacts::move_each(const double fraction)
  {
    for (Point &p : points)
      p.move(std::min(1., fraction * p.longest));
  }



  Condition InteriorContacts::Point::condition() const
  {
    if (!acts)
      return Condition::law;
    if (at.normal <= k_n * at.parting)
      return is_bond ? Condition::law : Condition::open; // no strength, no direction
    if (slides && k_s * at.forward > strength_forward)
      return Condition::slides_forward;
    if (slides && k_s * at.backward > strength_backward)
      return Condition::slides_backward;
    return Condition::sticks;
  }



  int InteriorContacts::conditions(std::vector<Condition> &now) const
  {
    int changed = 0;
    for (const Point &p : points)
      {
        const Condition condition = p.condition();
        changed += condition == now[p.spring] ? 0 : 1;
        now[p.spring] = condition;
      }
    return changed;
  }
} // namespace hybrid::dda
