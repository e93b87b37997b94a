// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/springs/bedrock_forces.h>
#include <hybrid/dda/step/open_close_iteration.h>
#include <hybrid/restart/archive.h>
#include <hybrid/scene/stopwatch.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  void OpenCloseIteration::move(const DdaState &state)
  {
    const std::vector<int> &blocks = islands.at_work();
#pragma omp parallel for schedule(static) if (is_worth_sharing(blocks.size()))
    for (std::size_t k = 0; k < blocks.size(); ++k)
      {
        const int b     = blocks[k];
        trial.motion[b] = BlockMotion(state.blocks[b].centroid, trial.increment[b]);
        for (int v = state.geometry.offset[b]; v < state.geometry.offset[b + 1]; ++v)
          trial.displacement[v] = trial.motion[b].displacement(state.geometry.vertices[v]);
      }
  }



  Vec6 OpenCloseIteration::acceleration_by_contacts(const int block) const
  {
    const Vec6 force = contact_force.segment<6>(6 * block);
    if (force.isZero(0.))
      return Vec6::Zero();
    return mass[block].solve(force);
  }



  double OpenCloseIteration::evaluate(const Model              &model,
                                      const DdaState           &state,
                                      const FoundationResponse &foundation)
  {
    move(state);
    {
      const Stopwatch timer(times.springs);
      springs.evaluate(model, state, trial);
    }
    return balance(model, state, foundation);
  }



  double OpenCloseIteration::balance(const Model              &model,
                                     const DdaState           &state,
                                     const FoundationResponse &foundation)
  {
    const int    n = model.n_blocks(), m = model.n_foundation_nodes();
    const double dt = trial.dt, weight = StepKinematics::contact_weight(model.newmark);
    // What is settled keeps its part of the forces and of the residual.
    const std::vector<int> &blocks = islands.at_work();
    residual.resize(6 * n + 2 * m);
    contact_force.resize(6 * n + 2 * m);
    absolute.resize(n);
    for (const int b : blocks)
      {
        residual.segment<6>(6 * b).setZero();
        contact_force.segment<6>(6 * b).setZero();
        absolute[b] = 0.;
      }
    residual.tail(2 * m).setZero();
    contact_force.tail(2 * m).setZero();
    {
      const Stopwatch timer(times.springs);
      springs.add_forces(residual, contact_force, absolute, &blocks);
    }
#pragma omp parallel for schedule(static) if (is_worth_sharing(blocks.size()))
    for (std::size_t k = 0; k < blocks.size(); ++k)
      {
        const int              b = blocks[k];
        const BlockProperties &p = model.blocks[b];
        const Vec6             inertial_force =
          mass[b] * (kinematics.inertia(b) * (trial.increment[b] - kinematics.predicted(b)));
        // The damping follows the mean strain rate of the step: with the rate at its end it would
        // feed what it damps while a contact holds (doc/theory.md).
        const Eigen::Vector3d stress = stresses.evaluate(
          p, state.blocks[b], trial.increment[b].tail<3>(), damping_time[b] / dt, b);
        Eigen::Map<Vec6> r(residual.data() + 6 * b);
        r += weight * contact_force.segment<6>(6 * b) - inertial_force;
        r[0] += p.pushed_mass * model.horizontal;
        r[1] -= p.weight * model.gravity;
        r.tail<3>() -= p.area * stress;
        // The last term is the round-off of a body that only flies: there no force is left to
        // compare with.
        absolute[b] += inertial_force.head<2>().norm() + p.weight * model.gravity +
                       p.pushed_mass * std::abs(model.horizontal) + p.size * stress.norm() +
                       1e-5 * p.mass * trial.increment[b].head<2>().norm() / (dt * dt);
      }

    if (model.water.action != Water::Action::none)
      add_water(model, state);
    if (!model.edge_loads.edges.empty())
      add_edge_loads(model, state);
    if (model.n_bedrock > 0)
      {
        for (const BoundaryEdge &edge : model.boundary)
          trial.rate[edge.block] = end_rate(edge.block);
        add_bedrock_forces({model, state, trial, incoming}, residual, absolute);
      }

    contact_increment = contact_force.tail(2 * m) - state.static_contact_force;
    residual.tail(2 * m) -= state.static_force - state.static_contact_force;
    force_increment = residual.tail(2 * m) + contact_increment;
    if (foundation.prescribed)
      residual.tail(2 * m).setZero();
    else
      {
        foundation_moved = trial.foundation - foundation.displacement;
        residual.tail(2 * m) += foundation_start + weight * contact_increment;
        const Stopwatch timer(times.surface_products);
        if (!foundation_moved.isZero(0.))
          solver.foundation_stiffness().subtract_whole_product(foundation_moved.data(),
                                                               residual.data() + 6 * n);
      }
    reference = absolute.norm();
    // A quiet mass on moving ground: the round-off of the foundation's balance.
    if (!foundation.prescribed)
      reference += 1e-5 * foundation.load.norm();
    return relative_residual();
  }



  bool OpenCloseIteration::is_balanced(const Step &step) const
  {
    return step.result.residual <= (local.is_on ? local.tolerance : step.model.iteration.tolerance);
  }



  double OpenCloseIteration::relative_residual() const
  {
    const double norm =
      local.is_on ? local.system.norm({residual, scale}) : residual.cwiseQuotient(scale).norm();
    return norm / std::max(reference, 1e-300);
  }



  void OpenCloseIteration::add_water(const Model &model, const DdaState &state)
  {
    const Geometry         &g      = state.geometry;
    const Water             water  = model.water.at(state.time + trial.dt);
    const std::vector<int> &blocks = islands.at_work();
#pragma omp parallel for schedule(static) if (is_worth_sharing(blocks.size()))
    for (std::size_t k = 0; k < blocks.size(); ++k)
      {
        const int b = blocks[k];
        if (model.is_bedrock(b))
          continue;
        const int first = g.offset[b];
        residual.segment<6>(6 * b) +=
          water_load(water,
                     model.blocks[b].area,
                     trial.motion[b],
                     {&g.vertices[first], &trial.displacement[first], g.offset[b + 1] - first})
            .force;
      }
  }



  void OpenCloseIteration::add_edge_loads(const Model &model, const DdaState &state)
  {
    const double factor = model.edge_loads.factor(state.time + trial.dt);
    for (const EdgeLoads::Edge &edge : model.edge_loads.edges)
      {
        if (islands.is_settled(edge.block))
          continue;
        const Vec6 force =
          factor *
          edge_force(edge, state.geometry, trial.displacement.data(), trial.motion[edge.block]);
        residual.segment<6>(6 * edge.block) += force;
        absolute[edge.block] += force.head<2>().norm();
      }
  }



  void OpenCloseIteration::update_stiffness(const Model &model, const Tangent &tangent)
  {
    SpringStiffness::Choice choice{tangent.follow_softening,
                                   StepKinematics::contact_weight(model.newmark),
                                   sliding_regularisation.value(),
                                   tangent.all || model.n_bedrock > 0 || model.blocks_yield,
                                   &islands.at_work()};
    stiffness.update(springs, trial, choice);
    if (!stiffness.changed_blocks().empty() || choice.all)
      return;
    // No spring is to blame that the residual does not fall: the directions may be.
    choice.all = true;
    stiffness.update(springs, trial, choice);
  }



  void OpenCloseIteration::assemble(const Model              &model,
                                    const DdaState           &state,
                                    const FoundationResponse &foundation,
                                    const Tangent            &tangent)
  {
    const Stopwatch timer(times.assembly);
    const double    dt = trial.dt;
    update_stiffness(model, tangent);
    const std::vector<int> &rows = stiffness.changed_blocks();
#pragma omp parallel for schedule(static) if (is_worth_sharing(rows.size()))
    for (std::size_t k = 0; k < rows.size(); ++k)
      {
        const int              b = rows[k];
        const BlockProperties &p = model.blocks[b];
        matrix.set_row_zero(b);
        matrix.diagonal[b] = kinematics.inertia(b) * mass[b].matrix();
        matrix.diagonal[b].bottomRightCorner<3, 3>() +=
          p.area * stresses.tangent(p, damping_time[b] / dt, b);
        stiffness.add_rows(springs, b, matrix);
      }
    matrix.set_nodes_zero();
    stiffness.add_foundation(springs, matrix);
    if (!stresses.is_symmetric())
      matrix.symmetric = false;
    if (model.n_bedrock > 0)
      add_bedrock_stiffness({model, state, trial, incoming}, matrix);
    if (foundation.prescribed)
      {
        // Prescribed nodes: no coupling, unit diagonal.
        std::fill(matrix.block_node.begin(), matrix.block_node.end(), BlockMatrix::Mat62::Zero());
        std::fill(matrix.node_block.begin(), matrix.node_block.end(), BlockMatrix::Mat26::Zero());
        std::fill(matrix.node_diagonal.begin(),
                  matrix.node_diagonal.end(),
                  Eigen::Matrix2d::Identity());
        std::fill(matrix.node_next.begin(), matrix.node_next.end(), Eigen::Matrix2d::Zero());
        std::fill(matrix.node_previous.begin(),
                  matrix.node_previous.end(),
                  Eigen::Matrix2d::Zero());
      }
    solver.matrix_changed(matrix, rows);
    secant.reset();
    tangent_dt             = dt;
    tangent_regularisation = sliding_regularisation.value();
    tangent_pattern        = matrix.pattern_version();
  }



  StepResult OpenCloseIteration::solve(const Model              &model,
                                       const DdaState           &state,
                                       const FoundationResponse &foundation,
                                       const double              dt,
                                       const std::vector<Vec6>  *guess)
  {
    StepResult result;
    begin(model, state, foundation, dt, guess);
    if (flies_too_far(model, result))
      return result;
    result.residual       = guess == nullptr ? choose_guess(model, state, foundation)
                                             : evaluate(model, state, foundation);
    result.first_residual = result.residual;
    const Step step{model, state, foundation, result};
    may_rest        = guess == nullptr && moves_nothing(step);
    at_rest         = may_rest && lies_in_balance(model);
    Attempt attempt = Attempt::converged;
    if (at_rest)
      memory = {};
    else
      attempt = iterate(step);
    constexpr int few_iterations = 4;
    expects_many                 = result.iterations > few_iterations;
    result.converged             = attempt == Attempt::converged;
    if (!result.converged)
      return result;
    finish(model);
    judge(model, result);
    result.converged = result.displacement_ratio <= model.iteration.maximum_displacement_ratio;
    return result;
  }



  Attempt OpenCloseIteration::iterate(const Step &step)
  {
    {
      const Stopwatch timer(times.springs);
      springs.connect(step.model, matrix);
    }
    stale = stale || tangent_dt != trial.dt || tangent_pattern != matrix.pattern_version() ||
            tangent_regularisation > 0.;
    repairs             = 0;
    const bool together = step.model.iteration.changes_together;
    Attempt    attempt  = together ? settle_contacts(step) : Attempt::failed;
    if (attempt == Attempt::failed)
      attempt = search(step);
    if (attempt == Attempt::failed && together && !step.model.iteration.is_patient)
      attempt = follow_path(step, Stride::common);
    return attempt;
  }



  bool OpenCloseIteration::may_go_on(const Step &step)
  {
    StepResult &result = step.result;
    if (result.iterations >= step.model.iteration.maximum_iterations)
      return false;
    result.stopped = watch && !watch(result);
    return !result.stopped;
  }



  void OpenCloseIteration::repair(const Step &step, const bool served, const double previous)
  {
    constexpr int whole_every = 3; ///< of a step's tangents is made of all rows
    if (!stale && served)
      return;
    const bool all = stale || (!local.is_on && ++repairs % whole_every == 0);
    assemble(step.model, step.state, step.foundation, {step.result.residual <= previous, all});
    stale = false;
  }



  void OpenCloseIteration::solve_linear(const Step &step, const double tolerance)
  {
    const Stopwatch timer(times.products);
    if (local.is_on)
      {
        local.system.solve(matrix,
                           step.foundation.prescribed ? nullptr : step.foundation.stiffness,
                           {residual, scale},
                           tolerance * reference,
                           update);
        return;
      }
    const LinearSolver::Result linear =
      solver.solve(matrix, residual, scale, tolerance * reference, update);
    times.factors += linear.factor_time;
    times.products -= linear.factor_time;
    step.result.solver_iterations += linear.iterations;
    step.result.factorizations += linear.factored ? 1 : 0;
  }



  void OpenCloseIteration::take(const Step &step, const double fraction)
  {
    const std::vector<int> &blocks = islands.at_work();
#pragma omp parallel for schedule(static) if (is_worth_sharing(blocks.size()))
    for (std::size_t k = 0; k < blocks.size(); ++k)
      trial.increment[blocks[k]] += fraction * update.segment<6>(6 * blocks[k]);
    if (!step.foundation.prescribed)
      trial.foundation += fraction * update.tail(trial.foundation.size());
  }



  void OpenCloseIteration::finish(const Model &model)
  {
#pragma omp parallel for schedule(static) if (is_worth_sharing(model.n_blocks()))
    for (int b = 0; b < model.n_blocks(); ++b)
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
                          StepKinematics::contact_weight(model.newmark) * c;
        trial.rate[b] = end_rate(b);
      }
  }



  void OpenCloseIteration::serialize(restart::Archive &archive)
  {
    bool is_current = tangent_pattern == matrix.pattern_version();
    archive(matrix, stiffness, tangent_dt, is_current, expects_many, stale);
    archive(memory.path_steps, memory.path_span, tangent_conditions, accuracy.left, secant);
    solver.serialize(archive);
    archive(times);
    if (!archive.is_reading())
      return;
    tangent_pattern = is_current ? matrix.pattern_version() : -1;
    is_restored     = matrix.n_blocks() > 0;
  }
} // namespace hybrid::dda
