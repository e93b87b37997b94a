// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a solved step.
#include <hybrid/dda/failure/joint_failure.h>
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/springs/surface_force.h>
#include <hybrid/dda/step/block_energy.h>
#include <hybrid/dda/step/bond_memory.h>
#include <hybrid/dda/step/contact_couple.h>
#include <hybrid/dda/step/step_problem.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    /// Part of a joint's spring that acts as a contact once the step is accepted [-].
    double contact_fraction_at_end(const Springs &springs, const DdaState &state, const int s)
    {
      const Springs::Spring &spring = springs.springs[s];
      if (spring.contact_fraction == 1. || state.joints[spring.joint].released)
        return 1.;
      return spring.law->contact_fraction(springs.responses[s].now.history);
    }



    /// A joint's spring that becomes a contact, or more of one.
    bool tears(const Springs &springs, const DdaState &state, const int s)
    {
      return contact_fraction_at_end(springs, state, s) != springs.springs[s].contact_fraction;
    }
  } // namespace



  double StepProblem::displacement_ratio(const int block) const
  {
    const Vec6 &d = trial.increment[block];
    return d.head<2>().norm() / model->blocks[block].size + std::abs(d[2]) +
           d.tail<3>().lpNorm<Eigen::Infinity>();
  }



  bool StepProblem::flies_too_far(StepResult &result) const
  {
    for (int b = 0; b < model->n_blocks(); ++b)
      {
        // Exact in free flight, but for the strains of a shape that rings.
        const Vec6  &d     = trial.increment[b];
        const double ratio = d.head<2>().norm() / model->blocks[b].size + std::abs(d[2]);
        if (ratio <= model->iteration.maximum_displacement_ratio || !springs.of_block(b).empty())
          continue;
        result.displacement_ratio = ratio;
        result.largest_block      = b;
        return true;
      }
    return false;
  }



  void StepProblem::judge(StepResult &result) const
  {
    constexpr double of_one_block = 1e-3; // a light one counts, however heavy the others are
    struct Judgement
    {
      double unbalanced = 0., ratio = 0., worst = 0.;
      int    largest = -1;

      void operator+=(const Judgement &other)
      {
        unbalanced += other.unbalanced;
        worst = std::max(worst, other.worst);
        if (other.ratio > ratio || largest < 0)
          {
            ratio   = other.ratio;
            largest = other.largest;
          }
      }
    };
    const Judgement all =
      shared_sum<Judgement>(model->blocks.size(), [&](const std::size_t b, Judgement &sum) {
        const double size    = model->blocks[b].size;
        const Vec6   inertia = mass[b] * (acceleration[b] + contact_acceleration[b]);
        const double left =
          inertia.head<2>().squaredNorm() + inertia.tail<4>().squaredNorm() / (size * size);
        sum += {left,
                displacement_ratio(static_cast<int>(b)),
                absolute[b] > 0. ? std::sqrt(left) / absolute[b] : 0.,
                static_cast<int>(b)};
      });
    result.displacement_ratio = all.ratio;
    result.largest_block      = all.largest;
    result.unbalanced =
      std::max(std::sqrt(all.unbalanced) / std::max(reference, 1e-300), of_one_block * all.worst);
  }



  void StepProblem::carry_contact_accelerations(DdaState &state, const bool any_tears) const
  {
    const int       n        = model->n_blocks();
    const int       n_joints = static_cast<int>(springs.first_contact());
    Eigen::VectorXd torn;  // forces of what becomes a contact of joints
    Eigen::VectorXd taken; // of what was taken back: neither carried on nor remembered
    if (any_tears)
      torn = taken = Eigen::VectorXd::Zero(contact_force.size());
    for (int s = 0; s < n_joints && any_tears; ++s)
      {
        if (!tears(springs, state, s))
          continue;
        const Springs::Spring  &spring = springs.springs[s];
        const SpringState      &now    = springs.responses[s].now;
        const Springs::Traction then   = spring.contact_traction(now);
        const Springs::Traction next =
          state.joints[spring.joint].released
            ? Springs::Traction{now.normal, now.shear}
            : Springs::contact_traction(now, contact_fraction_at_end(springs, state, s));
        springs.add_force(trial, s, {next.normal - then.normal, next.shear - then.shear}, torn);
        const Springs::Traction &back = springs.responses[s].taken_back;
        springs.add_force(trial, s, {-back.normal, -back.shear}, taken);
      }
    torn += taken;
    state.foundation_contact_force = contact_force.tail(2 * model->n_foundation_nodes());
    if (torn.size() > 0)
      state.foundation_contact_force += torn.tail(2 * model->n_foundation_nodes());
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int b = 0; b < n; ++b)
      {
        Vec6               c     = contact_acceleration[b];
        const BlockMotion &move  = trial.motion[b];
        BlockState        &block = state.blocks[b];
        if (torn.size() > 0)
          {
            c += mass[b].solve(torn.segment<6>(6 * b));
            const Vec6 back = Newmark::memory * mass[b].solve(taken.segment<6>(6 * b));
            if (model->newmark.filter > 0. && !back.isZero(0.))
              block.acceleration_change -= carried_rates(back, move.cosine, move.sine);
          }
        block.contact_acceleration = rotated_rates(c, move.cosine, move.sine);
      }
  }



  void StepProblem::accept(DdaState &state)
  {
    const double dt = trial.dt;
    accept_energy(state);
    state.surface_force = surface_force(*model, springs);
    state.time += dt;
    const double kept = (1. - Newmark::memory) * Newmark::remembered_in(dt, state.last_step);
    if (model->newmark.filter > 0.)
      state.last_step = dt;
    const bool any_tears = accept_joints(kept, state);
    const int  n         = model->n_blocks();
    if (model->newmark.filter > 0.)
      find_turned(state);
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int b = 0; b < n; ++b)
      accept_block(b, kept, state);
    accept_places(state);
    accept_contacts(state);
    carry_contact_accelerations(state, any_tears);
    if (!at_rest)
      keep_angular_momentum(state);
  }



  void StepProblem::accept_energy(DdaState &state) const
  {
    state.energy = audit_step(
      {*model, state, trial, springs, stresses, mass, damping_time, kinematics, incoming, at_rest});
    if (incoming.size() > 0)
      state.boundary_force = incoming;
    const double gamma    = model->newmark.gamma;
    const auto   contacts = contact_force.tail(2 * model->n_foundation_nodes());
    state.energy.foundation_work -=
      ((1. - gamma) * (state.foundation_force - state.foundation_contact_force) +
       gamma * (force_increment + state.static_force - contacts) + contacts)
        .dot(trial.foundation - state.foundation_displacement);
    const double filter = model->newmark.filter_in(trial.dt, state.last_step);
    if (filter == 0. || !foundation->prescribed || at_rest)
      return;
    // What the filter takes back of a bond's force acts on the base, too.
    const double taken = filter * remembered_base_work(*model, springs, trial, state);
    state.energy.foundation_work -= taken;
    state.energy.integration_loss -= taken;
  }



  bool StepProblem::accept_joints(const double kept, DdaState &state) const
  {
    const int n_joints  = static_cast<int>(springs.first_contact() / 2);
    bool      any_tears = false;
#pragma omp parallel for schedule(static) reduction(|| : any_tears) if (is_worth_sharing(n_joints))
    for (int k = 0; k < n_joints; ++k)
      {
        const int   j     = springs.springs[2 * k].joint;
        JointState &joint = state.joints[j];
        if (at_rest)
          joint.force_change.setZero();
        else if (model->newmark.filter > 0.)
          remember_bond_force(*model, springs, trial, kept, k, state);
        for (int end = 0; end < 2; ++end)
          joint.points[end] = springs.responses[2 * k + end].now;
        update_failure(model->joints[j], state.time, joint, model->blocks_yield);
        any_tears = any_tears || tears(springs, state, 2 * k) || tears(springs, state, 2 * k + 1);
      }
    return any_tears;
  }



  void StepProblem::find_turned(const DdaState &state)
  {
    const ProcessGroup *group = model->processes.get();
    const int           n     = model->n_blocks();
    turned.resize(n);
    const auto [first, last] = own_share(n, group);
#pragma omp parallel for schedule(static) if (is_worth_sharing(last - first))
    for (std::size_t b = first; b < last; ++b)
      turned[b] = turned_beyond_bonds(springs, trial, state, static_cast<int>(b));
    if (group != nullptr)
      group->gather_shares(turned.data(), n, sizeof(Vec2));
  }



  void StepProblem::accept_block(const int b, const double kept, DdaState &state) const
  {
    BlockState        &block = state.blocks[b];
    const BlockMotion &move  = trial.motion[b];
    block.centroid           = move.centroid;
    block.rotation += trial.increment[b][2];
    block.velocity_change =
      carried_rates(kinematics.remembered(b, trial.rate[b]), move.cosine, move.sine);
    block.velocity               = rotated_rates(trial.rate[b], move.cosine, move.sine);
    const Eigen::Vector3d strain = stresses.elastic_strain(trial.increment[b].tail<3>(), b);
    const Eigen::Vector3d stress = model->blocks[b].elasticity * strain;
    block.plastic_strain += shear_strain(stresses.plastic_strain(b));
    if (model->newmark.filter > 0.)
      {
        block.acceleration_change =
          carried_rates(kept * block.acceleration_change +
                          Newmark::memory *
                            (acceleration[b] - (block.acceleration - block.contact_acceleration)),
                        move.cosine,
                        move.sine);
        block.acceleration_change.head<2>() -= turned[b] / model->blocks[b].mass;
      }
    block.viscous_stress =
      rotated_stress(damping_time[b] / trial.dt * stress, move.cosine, move.sine);
    block.acceleration =
      rotated_rates(acceleration[b] + contact_acceleration[b], move.cosine, move.sine);
    block.stress =
      rotated_stress(block.stress + stresses.change(stress, strain, b), move.cosine, move.sine);
    if (stresses.branches().is_on())
      stresses.branches().advance(*model, move, strain, b, state);
    if (at_rest)
      block.velocity_change = block.acceleration_change = Vec6::Zero();
  }



  void StepProblem::accept_places(DdaState &state) const
  {
    const std::size_t n_vertices = state.geometry.vertices.size();
#pragma omp parallel for schedule(static) if (is_worth_sharing(n_vertices))
    for (std::size_t v = 0; v < n_vertices; ++v)
      state.geometry.vertices[v] += trial.displacement[v];
    state.foundation_displacement = trial.foundation;
    state.foundation_force        = force_increment + state.static_force;
    for (int k = 0; k < model->n_foundation_nodes(); ++k)
      state.geometry.foundation_nodes[k] =
        model->initial.foundation_nodes[k] + trial.foundation.segment<2>(2 * k);
  }



  void StepProblem::accept_contacts(DdaState &state) const
  {
    const int first     = static_cast<int>(springs.first_contact());
    const int n_springs = static_cast<int>(springs.springs.size());
#pragma omp parallel for schedule(static) if (is_worth_sharing(n_springs - first))
    for (int s = first; s < n_springs; ++s)
      {
        const Springs::Response &response = springs.responses[s];
        Contact                 &contact  = state.contacts[springs.springs[s].contact];
        contact.edge_position             = response.edge_position;
        // From where friction holds it now: the digits of a long way are wider than what a stiff
        // contact feels.
        contact.slip         = response.now.slip - response.now.history.plastic_slip;
        contact.plastic_slip = 0.;
        contact.state        = response.now.state;
        const double gap     = contact.stress_free_gap + response.now.gap;
        contact.pressed_gap  = response.now.gap < 0. ? gap : 0.;
        if (gap >= 0. && response.now.gap >= 0.) // they have parted
          contact.stress_free_gap = 0.;
      }
  }



  void StepProblem::keep_angular_momentum(DdaState &state) const
  {
    const double given =
      shared_sum<double>(model->blocks.size(), [&](const std::size_t n, double &sum) {
        const int b = static_cast<int>(n);
        if (!kinematics.is_filtered(b))
          return;
        const double couple = contact_couple(springs, trial, kinematics.start_rates(), mass, b);
        if (couple == 0.)
          return;
        // The block turns as a whole: in a slender one, whose turn and shear are nearly one motion,
        // a couple on the turn alone would tear the two apart.
        const double inertia = (mass[b] * Vec6::Unit(2))[2], change = couple / inertia;
        sum += change * ((mass[b] * trial.rate[b])[2] + 0.5 * couple);
        state.blocks[b].velocity[2] += change;
      });
    state.energy.kinetic += given;
    state.energy.integration_loss -= given;
  }
} // namespace hybrid::dda
