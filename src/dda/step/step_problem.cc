// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/step/step_problem.h>
#include <hybrid/scene/stopwatch.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybrid::dda
{
  double StepProblem::evaluate()
  {
    move_blocks();
    bonds_hold = false;
    {
      const Stopwatch timer(times.springs);
      if (is_shared())
        springs.choose(shared.springs());
      springs.evaluate(*model, *before, trial);
      if (is_shared())
        springs.widen();
    }
    is_complete = !is_shared();
    return balance();
  }



  bool StepProblem::prescribe(const std::vector<Condition> &conditions)
  {
    if (!is_shared())
      return springs.prescribe(*model, *before, trial, conditions);
    springs.choose(shared.springs());
    const bool any = springs.prescribe(*model, *before, trial, conditions);
    springs.widen();
    return !shared.all(!any);
  }



  bool StepProblem::hold_bonds()
  {
    if (is_shared())
      springs.choose(shared.springs());
    bonds_hold = springs.hold_bonds(*model, *before, trial);
    if (is_shared())
      {
        springs.widen();
        bonds_hold = !shared.all(!bonds_hold);
      }
    return bonds_hold;
  }



  void StepProblem::complete(const std::vector<Condition> *conditions)
  {
    if (!is_shared())
      return;
    const Stopwatch timer(times.springs);
    springs.choose(shared.other_springs());
    if (!is_complete)
      springs.evaluate(*model, *before, trial);
    if (conditions != nullptr)
      springs.prescribe(*model, *before, trial, *conditions);
    if (bonds_hold)
      springs.hold_bonds(*model, *before, trial);
    springs.widen();
    if (model->blocks_yield && !is_complete)
      for (int b = 0; b < model->n_blocks(); ++b)
        if (!shared.owns(b))
          block_stress(b);
    is_complete = true;
  }



  void StepProblem::evaluate_alone()
  {
    if (is_narrow())
      return; // all do so anyway
    complete();
    shared.stop();
  }



  double StepProblem::relative_residual() const
  {
    return is_narrow() ? few->norm(left()) / std::max(reference, 1e-300) : whole_residual();
  }



  double StepProblem::whole_residual() const
  {
    return residual.cwiseQuotient(scale).norm() / std::max(reference, 1e-300);
  }



  double StepProblem::left_of(const int block) const
  {
    const auto r = residual.segment<6>(6 * block);
    return std::sqrt(r.head<2>().squaredNorm() +
                     r.tail<4>().squaredNorm() / std::pow(model->blocks[block].size, 2));
  }



  StepProblem::Imbalance StepProblem::imbalance(std::vector<int> &blocks) const
  {
    const double part = std::max(nearly_at_rest, 100. * model->iteration.tolerance);
    const int    n    = model->n_mass(); // the bedrock's loads at rest are not among its forces
    Imbalance    found;
    if (n == 0 || whole_residual() * reference <= part * absolute.head(n).minCoeff())
      return found;   // the scale is at most that of left_of()
    double most = 0.; // acceleration, squared
    for (int b = 0; b < n; ++b)
      most = std::max(most, inertial_acceleration(b).head<2>().squaredNorm());
    most                = std::sqrt(most);
    found.least_allowed = std::numeric_limits<double>::infinity();
    for (int b = 0; b < n; ++b)
      {
        const double left    = left_of(b);
        const double allowed = part * (absolute[b] + model->blocks[b].mass * most);
        if (!(left > allowed) || allowed == 0.)
          continue;
        blocks.push_back(b);
        found.worst         = std::max(found.worst, left / allowed);
        found.least_allowed = std::min(found.least_allowed, allowed);
      }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    return found;
  }



  void StepProblem::move(const Eigen::VectorXd &update, const double fraction)
  {
    const std::vector<int> &moving = at_work();
#pragma omp parallel for schedule(static) if (is_worth_sharing(moving.size()))
    for (std::size_t k = 0; k < moving.size(); ++k)
      trial.increment[moving[k]] += fraction * update.segment<6>(6 * moving[k]);
    if (!foundation->prescribed)
      trial.foundation += fraction * update.tail(trial.foundation.size());
  }



  void StepProblem::keep(TrialPlace &place) const
  {
    place.increment.assign(trial.increment.begin(), trial.increment.end());
    place.foundation = trial.foundation;
  }



  double StepProblem::go_back(const TrialPlace &place)
  {
    for (const int b : at_work())
      trial.increment[b] = place.increment[b];
    trial.foundation = place.foundation;
    return evaluate();
  }



  void StepProblem::narrow(const LocalSystem &bodies)
  {
    complete();
    blocks_at_work.narrow(bodies.changing_blocks());
    springs.narrow(bodies.blocks(), bodies.nodes());
    few = &bodies;
  }



  void StepProblem::widen()
  {
    blocks_at_work.widen();
    springs.widen();
    few = nullptr;
  }



  void StepProblem::move_blocks()
  {
    const Geometry         &geometry = before->geometry;
    const std::vector<int> &moving   = at_work();
#pragma omp parallel for schedule(static) if (is_worth_sharing(moving.size()))
    for (std::size_t k = 0; k < moving.size(); ++k)
      {
        const int b     = moving[k];
        trial.motion[b] = BlockMotion(before->blocks[b].centroid, trial.increment[b]);
        for (int v = geometry.offset[b]; v < geometry.offset[b + 1]; ++v)
          trial.displacement[v] = trial.motion[b].displacement(geometry.vertices[v]);
      }
  }



  Vec6 StepProblem::acceleration_by_contacts(const int block) const
  {
    const Vec6 force = contact_force.segment<6>(6 * block);
    if (force.isZero(0.))
      return Vec6::Zero();
    return mass[block].solve(force);
  }



  double StepProblem::balance()
  {
    clear_forces();
    {
      const Stopwatch timer(times.springs);
      springs.add_forces(residual, contact_force, absolute, &summed());
    }
    add_block_forces();
    if (model->water.action != Water::Action::none)
      add_water();
    if (!model->edge_loads.edges.empty())
      add_edge_loads();
    exchange_sums();
    if (model->n_bedrock > 0)
      {
        for (const BoundaryEdge &edge : model->boundary)
          trial.rate[edge.block] = end_rate(edge.block);
        add_bedrock_forces(bedrock(), at_work(), residual, absolute);
      }
    add_foundation_balance();
    reference = absolute.norm();
    // A quiet mass on moving ground: the round-off of the foundation's balance.
    if (!foundation->prescribed)
      reference += 1e-5 * foundation->load.norm();
    return relative_residual();
  }



  void StepProblem::clear_forces()
  {
    const int n = model->n_blocks(), m = model->n_foundation_nodes();
    residual.resize(6 * n + 2 * m);
    contact_force.resize(6 * n + 2 * m);
    absolute.resize(n);
    // What is held keeps its part of the forces and of the residual.
    for (const int b : summed())
      {
        residual.segment<6>(6 * b).setZero();
        contact_force.segment<6>(6 * b).setZero();
        absolute[b] = 0.;
      }
    residual.tail(2 * m).setZero();
    contact_force.tail(2 * m).setZero();
  }



  void StepProblem::exchange_sums()
  {
    if (is_shared())
      {
        const Stopwatch timer(times.springs);
        shared.exchange(residual, &absolute);
        lacks_contacts = true;
      }
    else if (!is_narrow())
      lacks_contacts = false;
  }



  Eigen::Vector3d StepProblem::block_stress(const int block)
  {
    return stresses.evaluate(model->blocks[block],
                             before->blocks[block],
                             trial.increment[block].tail<3>(),
                             damping_time[block] / trial.dt,
                             block);
  }



  void StepProblem::add_block_forces()
  {
    const std::vector<int> &moving = summed();
    const double            dt = trial.dt, weight = StepKinematics::contact_weight(model->newmark);
#pragma omp parallel for schedule(static) if (is_worth_sharing(moving.size()))
    for (std::size_t k = 0; k < moving.size(); ++k)
      {
        const int              b              = moving[k];
        const BlockProperties &p              = model->blocks[b];
        const Vec6             inertial_force = mass[b] * inertial_acceleration(b);
        // The damping follows the mean strain rate of the step: with the rate at its end it would
        // feed what it damps while a contact holds (doc/theory.md).
        const Eigen::Vector3d stress = block_stress(b);
        Eigen::Map<Vec6>      r(residual.data() + 6 * b);
        r += weight * contact_force.segment<6>(6 * b) - inertial_force;
        r[0] += p.pushed_mass * model->horizontal;
        r[1] -= p.weight * model->gravity;
        if (!model->dead_loads.empty() && !model->is_bedrock(b))
          r += model->dead_loads[b];
        r.tail<3>() -= p.area * stress;
        // The last term is the round-off of a body that only flies: there no force is left to
        // compare with.
        absolute[b] += inertial_force.head<2>().norm() + p.weight * model->gravity +
                       p.pushed_mass * std::abs(model->horizontal) + p.size * stress.norm() +
                       1e-5 * p.mass * trial.increment[b].head<2>().norm() / (dt * dt);
      }
  }



  void StepProblem::add_water()
  {
    const Geometry         &g      = before->geometry;
    const Water             water  = model->water.at(before->time + trial.dt);
    const std::vector<int> &moving = summed();
#pragma omp parallel for schedule(static) if (is_worth_sharing(moving.size()))
    for (std::size_t k = 0; k < moving.size(); ++k)
      {
        const int b = moving[k];
        if (model->is_bedrock(b))
          continue;
        const int first = g.offset[b];
        residual.segment<6>(6 * b) +=
          water_load(water,
                     model->blocks[b].area,
                     trial.motion[b],
                     {&g.vertices[first], &trial.displacement[first], g.offset[b + 1] - first})
            .force;
      }
  }



  void StepProblem::add_edge_loads()
  {
    const double factor = model->edge_loads.factor(before->time + trial.dt);
    for (const EdgeLoads::Edge &edge : model->edge_loads.edges)
      {
        if (is_shared() ? !shared.owns(edge.block) : blocks_at_work.is_held(edge.block))
          continue;
        const Vec6 force =
          factor *
          edge_force(edge, before->geometry, trial.displacement.data(), trial.motion[edge.block]);
        residual.segment<6>(6 * edge.block) += force;
        absolute[edge.block] += force.head<2>().norm();
      }
  }



  void StepProblem::add_foundation_balance()
  {
    const int m       = 2 * model->n_foundation_nodes();
    contact_increment = contact_force.tail(m) - before->static_contact_force;
    residual.tail(m) -= before->static_force - before->static_contact_force;
    force_increment = residual.tail(m) + contact_increment;
    if (foundation->prescribed)
      {
        residual.tail(m).setZero();
        return;
      }
    foundation_moved = trial.foundation - foundation->displacement;
    residual.tail(m) +=
      foundation_start + StepKinematics::contact_weight(model->newmark) * contact_increment;
    const Stopwatch timer(times.surface_products);
    if (!foundation_moved.isZero(0.))
      surface->subtract_whole_product(foundation_moved.data(),
                                      residual.data() + 6 * model->n_blocks());
  }



  Mat6 StepProblem::block_stiffness(const int block) const
  {
    const BlockProperties &p      = model->blocks[block];
    Mat6                   result = kinematics.inertia(block) * mass[block].matrix();
    result.bottomRightCorner<3, 3>() +=
      p.area * stresses.tangent(p, damping_time[block] / trial.dt, block);
    return result;
  }



  void StepProblem::finish(const bool rests)
  {
    at_rest = rests;
    complete();
    if (lacks_contacts)
      shared.exchange(contact_force, nullptr);
    lacks_contacts = false;
#pragma omp parallel for schedule(static) if (is_worth_sharing(model->n_blocks()))
    for (int b = 0; b < model->n_blocks(); ++b)
      {
        const Vec6 c            = acceleration_by_contacts(b);
        contact_acceleration[b] = c;
        if (at_rest)
          {
            acceleration[b] = -c;
            trial.rate[b].setZero();
            continue;
          }
        acceleration[b] = kinematics.inertia(b) * (trial.increment[b] - kinematics.predicted(b)) -
                          StepKinematics::contact_weight(model->newmark) * c;
        trial.rate[b] = end_rate(b);
      }
  }
} // namespace hybrid::dda
