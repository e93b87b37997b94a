// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/springs/bedrock_forces.h>
#include <hybrid/dda/step/open_close_iteration.h>
#include <hybrid/restart/archive.h>
#include <hybrid/scene/stopwatch.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    /// Weight of contact forces beside M (d - d*) / (beta dt^2), for their dt^2/2 in d.
    double contact_weight(const Newmark &newmark)
    {
      return 0.5 / newmark.beta;
    }



    /// Fraction of the @p residual that the linear solver may leave: the faster the residual falls,
    /// the less (Eisenstat and Walker 1996, choice 2).
    double forcing_term(const double residual, const double previous)
    {
      constexpr double max_term = 1e-3, factor = 0.1;
      const double     ratio = residual / previous;
      return std::min(max_term, factor * ratio * ratio);
    }
  } // namespace



  void OpenCloseIteration::subtract_foundation_product(const Eigen::VectorXd      &displacement,
                                                       Eigen::Ref<Eigen::VectorXd> force) const
  {
    const InterfaceStiffness &rock = solver.foundation_stiffness();
    const Eigen::Index        n    = displacement.size();
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (Eigen::Index k = 0; k < n; ++k)
      force[k] -= rock.row_product(static_cast<int>(k), displacement);
  }



  void OpenCloseIteration::move(const DdaState &state)
  {
    const int n = static_cast<int>(trial.increment.size());
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int b = 0; b < n; ++b)
      {
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
    return mass[block].llt().solve(force);
  }



  double OpenCloseIteration::evaluate(const Model              &model,
                                      const DdaState           &state,
                                      const FoundationResponse &foundation)
  {
    const int    n = model.n_blocks(), m = model.n_foundation_nodes();
    const double dt = trial.dt, beta = model.newmark.beta, weight = contact_weight(model.newmark);
    move(state);
    residual.setZero(6 * n + 2 * m);
    contact_force.setZero(6 * n + 2 * m);
    absolute.setZero(n);
    {
      const Stopwatch timer(times.springs);
      springs.evaluate(model,
                       state,
                       trial,
                       full_steps ? Springs::SlipReversal::locks : Springs::SlipReversal::slides);
      springs.add_forces(residual, contact_force, absolute);
    }
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int b = 0; b < n; ++b)
      {
        const BlockProperties &p = model.blocks[b];
        const Vec6 inertia = mass[b] * ((trial.increment[b] - predicted[b]) / (beta * dt * dt));
        // The damping follows the mean strain rate of the step: with the rate at its end it would
        // feed what it damps while a contact holds (doc/theory.md).
        const Eigen::Vector3d strain = (1. + damping_time[b] / dt) * trial.increment[b].tail<3>();
        const Eigen::Vector3d stress = state.blocks[b].stress + p.elasticity * strain;
        Eigen::Map<Vec6>      r(residual.data() + 6 * b);
        r += weight * contact_force.segment<6>(6 * b) - inertia;
        r[0] += p.pushed_mass * model.horizontal;
        r[1] -= p.weight * model.gravity;
        r.tail<3>() -= p.area * stress;
        // The last term is the round-off of a body that only flies: there no force is left to
        // compare with.
        absolute[b] += inertia.head<2>().norm() + p.weight * model.gravity +
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
          subtract_foundation_product(foundation_moved, residual.tail(2 * m));
      }
    reference = absolute.norm();
    // A quiet mass on moving ground: the round-off of the foundation's balance.
    if (!foundation.prescribed)
      reference += 1e-5 * foundation.load.norm();
    return residual.cwiseQuotient(scale).norm() / std::max(reference, 1e-300);
  }



  void OpenCloseIteration::add_water(const Model &model, const DdaState &state)
  {
    const Geometry &g = state.geometry;
    for (int b = 0; b < model.n_mass(); ++b)
      {
        const int first = g.offset[b];
        residual.segment<6>(6 * b) +=
          water_load(model.water,
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
                                   contact_weight(model.newmark),
                                   sliding_regularisation.value(),
                                   tangent.all || model.n_bedrock > 0};
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
    const double    dt = trial.dt, beta = model.newmark.beta;
    update_stiffness(model, tangent);
    const std::vector<int> &rows = stiffness.changed_blocks();
#pragma omp parallel for schedule(static) if (is_worth_sharing(rows.size()))
    for (std::size_t k = 0; k < rows.size(); ++k)
      {
        const int              b = rows[k];
        const BlockProperties &p = model.blocks[b];
        matrix.set_row_zero(b);
        matrix.diagonal[b] = mass[b] / (beta * dt * dt);
        matrix.diagonal[b].bottomRightCorner<3, 3>() +=
          p.area * (1. + damping_time[b] / dt) * p.elasticity;
        stiffness.add_rows(springs, b, matrix);
      }
    matrix.set_nodes_zero();
    stiffness.add_foundation(springs, matrix);
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
    tangent_dt             = dt;
    tangent_regularisation = sliding_regularisation.value();
    tangent_pattern        = matrix.pattern_version();
  }



  LinearSolver::Result OpenCloseIteration::solve_linear(const double tolerance)
  {
    const Stopwatch            timer(times.products);
    const LinearSolver::Result result = solver.solve(matrix, residual, scale, tolerance, update);
    times.factors += result.factor_time;
    times.products -= result.factor_time;
    return result;
  }



  OpenCloseIteration::LineSearch
  OpenCloseIteration::search_line(const Model              &model,
                                  const DdaState           &state,
                                  const FoundationResponse &foundation)
  {
    // Work of the residual along the update; zero at the best place. Falling work is followed to
    // its end: only a spring that grew stiffer on the way can turn its sign. No search where the
    // unsymmetric tangent points uphill.
    constexpr double good_fraction = 0.3;
    constexpr int    maximum_cuts  = 10;
    const double     start         = residual.dot(update);
    double           lower = 0., upper = 1., work_lower = start, work_upper = 0.;
    double           fraction = 1., done = 0.;
    for (int cut = 0;; ++cut)
      {
        for (int b = 0; b < model.n_blocks(); ++b)
          trial.increment[b] += (fraction - done) * update.segment<6>(6 * b);
        if (!foundation.prescribed)
          trial.foundation += (fraction - done) * update.tail(trial.foundation.size());
        done = fraction;
        if (full_steps)
          springs.remember();
        const double norm = evaluate(model, state, foundation);
        const double work = residual.dot(update);
        if (full_steps || start <= 0. || cut == maximum_cuts || !std::isfinite(norm) ||
            std::abs(work) <= good_fraction * start || (cut == 0 && work > 0.))
          return {norm, done};
        // Regula falsi; an end that stays is given half its weight (Illinois).
        if (work > 0.)
          {
            lower      = fraction;
            work_lower = work;
            work_upper *= 0.5;
          }
        else
          {
            upper      = fraction;
            work_upper = work;
            work_lower *= cut > 0 ? 0.5 : 1.;
          }
        const double zero = work_lower / (work_lower - work_upper);
        fraction          = lower + std::min(0.95, std::max(0.05, zero)) * (upper - lower);
      }
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

    constexpr int    stall_window     = 10;
    constexpr double stalled_fraction = 0.3;
    constexpr int    whole_every      = 3; ///< of a step's tangents is made of all rows
    constexpr int    few_iterations   = 4;
    int              repairs          = 0;
    double           window_start     = std::numeric_limits<double>::infinity();
    int              search_start     = 0; ///< iteration in which the line search begins

    result.residual = guess == nullptr ? choose_guess(model, state, foundation)
                                       : evaluate(model, state, foundation);
    // The first linear system is solved to the end where that may be all.
    double previous = expects_many ? result.residual : std::numeric_limits<double>::infinity();
    expects_many    = true;
    {
      const Stopwatch timer(times.springs);
      springs.connect(model, matrix);
    }
    bool stale = tangent_dt != dt || tangent_pattern != matrix.pattern_version() ||
                 tangent_regularisation > 0.;
    full_steps = full_step_phase.begin(model.iteration.max_full_steps, result.residual);
    for (; result.iterations < model.iteration.maximum_iterations; ++result.iterations)
      {
        if (full_steps && !full_step_phase.go_on())
          {
            search_start    = result.iterations;
            result.residual = begin_line_search(model, state, foundation);
            stale           = true;
          }
        if (!std::isfinite(result.residual))
          return result;
        if (result.iterations > 0 && result.residual <= model.iteration.tolerance &&
            !springs.any_held())
          {
            result.converged = true;
            break;
          }
        result.stopped = watch && !watch(result);
        if (result.stopped)
          return result;
        if (!full_steps && (result.iterations - search_start) % stall_window == 0)
          {
            if (result.residual > stalled_fraction * window_start)
              return result; // a shorter step is cheaper than more of the same
            window_start = result.residual;
          }
        // A kept tangent that no longer takes most of the residual away is rebuilt.
        if (stale || (result.iterations > 0 && result.residual > 1e-3 * previous))
          {
            const bool all = stale || ++repairs % whole_every == 0;
            assemble(model, state, foundation, {result.residual <= previous, all});
          }
        stale = false;

        const double               left   = std::max(0.2 * model.iteration.tolerance,
                                     forcing_term(result.residual, previous) * result.residual);
        const LinearSolver::Result linear = solve_linear(left * reference);
        result.solver_iterations += linear.iterations;
        result.factorizations += linear.factored ? 1 : 0;
        previous                  = result.residual;
        const LineSearch searched = search_line(model, state, foundation);
        result.residual           = searched.residual;
        if (full_steps)
          full_step_phase.judge(result.residual);
        if (model.iteration.regularises_sliding)
          stale = sliding_regularisation.adapt(searched.fraction);
      }
    if (!result.converged)
      return result;
    expects_many = result.iterations > few_iterations;
    finish(model);
    judge(model, result);
    result.converged = result.displacement_ratio <= model.iteration.maximum_displacement_ratio;
    return result;
  }



  void OpenCloseIteration::finish(const Model &model)
  {
    const double inertia = 1. / (model.newmark.beta * trial.dt * trial.dt);
#pragma omp parallel for schedule(static) if (is_worth_sharing(model.n_blocks()))
    for (int b = 0; b < model.n_blocks(); ++b)
      {
        const Vec6 c            = acceleration_by_contacts(b);
        contact_acceleration[b] = c;
        acceleration[b] =
          inertia * (trial.increment[b] - predicted[b]) - contact_weight(model.newmark) * c;
        trial.rate[b] = end_rate(b);
      }
  }



  void OpenCloseIteration::serialize(restart::Archive &archive)
  {
    bool is_current = tangent_pattern == matrix.pattern_version();
    archive(matrix, stiffness, tangent_dt, is_current, expects_many);
    solver.serialize(archive, matrix);
    archive(times);
    if (!archive.is_reading())
      return;
    tangent_pattern = is_current ? matrix.pattern_version() : -1;
    is_restored     = matrix.n_blocks() > 0;
  }
} // namespace hybrid::dda
