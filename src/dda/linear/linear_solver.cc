// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/linear_solver.h>
#include <hybrid/restart/archive.h>
#include <hybrid/scene/stopwatch.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    constexpr int hard_limit = 2000;

    // Per 6x6 block, on a core of 10 GB/s and 33 GFLOP/s [s]; measured in the benchmarks' scenes,
    // of 400 to 20,000 blocks (doc/notes/solver.md).
    constexpr double time_of_sweep   = 32e-9; ///< of one in the matrix
    constexpr double time_of_entry   = 30e-9; ///< of one that is read, from memory
    constexpr double time_in_cache   = 10e-9; ///< the same from a cache
    constexpr double fits_cache      = 8e6;   ///< all entries of a solution [B]
    constexpr double time_of_product = 13e-9;
    constexpr double time_of_loading = 80e-9; ///< of one in the matrix, to factorise it
    constexpr double time_of_front   = 2e-6;  ///< in a factorisation
  }                                           // namespace



  namespace
  {
    double count_entries(const BlockMatrix &matrix)
    {
      double n = matrix.n_blocks();
      for (std::size_t s = 0; s < matrix.pairs.size(); ++s)
        n += matrix.is_zero(s) ? 0. : 2.;
      return n;
    }
  } // namespace



  void LinearSolver::matrix_changed(const BlockMatrix &matrix, const std::vector<int> &blocks)
  {
    factor_is_current = false;
    n_entries         = -1.;
    const auto size   = static_cast<std::size_t>(matrix.n_blocks());
    const bool is_new = unswept_pattern != matrix.pattern_version() || is_unswept.size() != size;
    if (is_new)
      {
        is_unswept.assign(size, 0);
        unswept.clear();
        unswept.reserve(size);
        unswept_pattern = matrix.pattern_version();
      }
    for (const int b : blocks)
      if (is_unswept[b] == 0)
        {
          is_unswept[b] = 1;
          unswept.push_back(b);
        }
    sweeps_are_current = false;
    if (is_new && keeps_sweeps(matrix)) // with the memory for it
      prepare_sweeps(matrix);
  }



  void LinearSolver::prepare_sweeps(const BlockMatrix &matrix)
  {
    if (sweeps_are_current)
      return;
    foundation.matrix_changed(matrix);
    ssor.set(matrix, foundation, unswept);
    for (const int b : unswept)
      is_unswept[b] = 0;
    unswept.clear();
    sweeps_are_current = true;
  }



  void LinearSolver::release_sweeps()
  {
    if (!ssor.is_set())
      return;
    ssor.release();
    sweeps_are_current = false;
    for (Eigen::VectorXd *work : {&dual_r, &dual_p, &shadow, &t, &dual_t})
      work->resize(0);
  }



  void LinearSolver::matrix_restored(const BlockMatrix &matrix)
  {
    n_entries = count_entries(matrix);
  }



  void LinearSolver::serialize(restart::Archive &archive)
  {
    archive(choice, factor_is_current);
    factor.serialize(archive);
  }



  void LinearSolver::multiply(const BlockMatrix     &matrix,
                              const Eigen::VectorXd &x,
                              Eigen::VectorXd       &y) const
  {
    matrix.multiply(x, y);
    const int nodes = 6 * matrix.n_blocks();
    foundation.add_product(x.data() + nodes, y.data() + nodes);
  }



  void LinearSolver::precondition(const BlockMatrix &matrix, const Eigen::VectorXd &residual)
  {
    const int nodes = 6 * matrix.n_blocks();
    factor.solve(residual, z);
    if (factor.has_foundation())
      return;
    z.tail(z.size() - nodes) = residual.tail(z.size() - nodes);
    matrix.add_blocks_to_nodes(z, z, -1.);
    foundation.solve_alone(z.data() + nodes);
  }



  struct LinearSolver::Preconditioned
  {
    LinearSolver &solver;
    const Target &target;
    double        bound = target.tolerance; ///< of the residual without its part below the diagonal

    void multiply(const Eigen::VectorXd &x, Eigen::VectorXd &y)
    {
      solver.ssor.multiply(x, y);
    }

    void dual(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
    {
      solver.ssor.multiply_diagonal(x, y);
    }

    /// Of the last product.
    const Eigen::VectorXd &direction(const Eigen::VectorXd &x) const
    {
      return x;
    }

    void weigh(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
    {
      y = solver.ssor.weights().cwiseProduct(x);
    }

    bool solved(const Eigen::VectorXd &residual, const Eigen::VectorXd &dual_residual)
    {
      if (dual_residual.cwiseQuotient(target.scale).norm() > bound)
        return false;
      solver.ssor.undo_forward(residual, solver.z);
      const bool done = target.met_by(solver.z);
      if (!done)
        bound *= 0.3;
      return done;
    }
  };



  struct LinearSolver::Factored
  {
    LinearSolver      &solver;
    const BlockMatrix &matrix;
    const Target      &target;

    void multiply(const Eigen::VectorXd &x, Eigen::VectorXd &y)
    {
      solver.precondition(matrix, x);
      solver.multiply(matrix, solver.z, y);
    }

    /// Of the last product: preconditioned, it adds to the solution itself.
    const Eigen::VectorXd &direction(const Eigen::VectorXd &) const
    {
      return solver.z;
    }

    void weigh(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
    {
      y = x;
    }

    bool solved(const Eigen::VectorXd &residual, const Eigen::VectorXd &) const
    {
      return target.met_by(residual);
    }
  };



  LinearSolver::Result LinearSolver::conjugate_gradients(Preconditioned &system, const int limit)
  {
    Result result;
    dual_r.resize(r.size());
    system.dual(r, dual_r);
    p          = r;
    dual_p     = dual_r;
    double rho = r.dot(dual_r);
    while (result.iterations < limit)
      {
        ++result.iterations;
        system.multiply(p, q);
        const double alpha = rho / dual_p.dot(q);
        if (!(alpha > 0.) || !std::isfinite(alpha))
          return result;
        unknown += alpha * p;
        r -= alpha * q;
        system.dual(r, dual_r);
        result.converged = system.solved(r, dual_r);
        if (result.converged)
          return result;
        const double next = r.dot(dual_r);
        p                 = r + (next / rho) * p;
        dual_p            = dual_r + (next / rho) * dual_p;
        rho               = next;
      }
    return result;
  }



  template <typename System>
  LinearSolver::Result LinearSolver::bicgstab(System &system, const int limit)
  {
    Result result;
    for (Eigen::VectorXd *work : {&dual_r, &t, &dual_t})
      work->resize(r.size());
    system.weigh(r, dual_r);
    shadow     = dual_r;
    double rho = r.dot(shadow);
    p          = r;
    while (result.iterations < limit)
      {
        ++result.iterations;
        system.multiply(p, q);
        const double alpha = rho / q.dot(shadow);
        if (!std::isfinite(alpha))
          return result;
        unknown += alpha * system.direction(p);
        r -= alpha * q;
        system.weigh(r, dual_r);
        result.converged = system.solved(r, dual_r);
        if (result.converged)
          return result;
        system.multiply(r, t);
        system.weigh(t, dual_t);
        const double omega = t.dot(dual_r) / t.dot(dual_t);
        if (!std::isfinite(omega) || omega == 0.)
          return result;
        unknown += omega * system.direction(r);
        r -= omega * t;
        dual_r -= omega * dual_t;
        result.converged = system.solved(r, dual_r);
        if (result.converged)
          return result;
        const double next = r.dot(shadow);
        const double beta = next / rho * alpha / omega;
        if (!std::isfinite(beta))
          return result;
        p   = r + beta * (p - omega * q);
        rho = next;
      }
    return result;
  }



  LinearSolver::Result LinearSolver::conjugate_gradients(Factored &system, const Target &target)
  {
    Result result;
    double rho = 0.;
    while (result.iterations < target.limit)
      {
        precondition(system.matrix, r);
        const double next = r.dot(z);
        if (result.iterations == 0)
          p = z;
        else
          p = z + (next / rho) * p;
        rho = next;
        ++result.iterations;
        multiply(system.matrix, p, q);
        const double alpha = rho / p.dot(q);
        if (!(alpha > 0.) || !std::isfinite(alpha))
          return result;
        unknown += alpha * p;
        r -= alpha * q;
        result.converged = target.met_by(r);
        if (result.converged)
          return result;
      }
    return result;
  }



  LinearSolver::Result LinearSolver::solve_by_sweeps(const BlockMatrix     &matrix,
                                                     const Eigen::VectorXd &b,
                                                     const Target          &target,
                                                     Eigen::VectorXd       &x)
  {
    prepare_sweeps(matrix);
    Preconditioned system{*this, target};
    unknown.setZero();
    r = b;
    ssor.sweep_forward(r, r);
    const Result result =
      is_symmetric ? conjugate_gradients(system, target.limit) : bicgstab(system, target.limit);
    ssor.sweep_backward(unknown, x);
    return result;
  }



  LinearSolver::Result LinearSolver::solve_with_factor(const BlockMatrix     &matrix,
                                                       const Eigen::VectorXd &b,
                                                       const Target          &target,
                                                       Eigen::VectorXd       &x)
  {
    Factored system{*this, matrix, target};
    unknown.setZero();
    r                      = b;
    const bool is_definite = is_symmetric && factor.is_symmetric();
    const bool is_decoupled =
      factor.has_foundation() ||
      (!foundation.exists() && std::all_of(matrix.node_block.begin(),
                                           matrix.node_block.end(),
                                           [](const auto &part) { return part.isZero(0.); }));
    const Result result = is_definite && is_decoupled ? conjugate_gradients(system, target)
                                                      : bicgstab(system, target.limit);
    x                   = unknown;
    return result;
  }



  PreconditionerChoice::Costs LinearSolver::costs(const BlockMatrix &matrix) const
  {
    const SparseFactor::Counts counts = factor.counts(matrix.n_blocks());
    const double               n      = n_entries;
    const bool   one_product = is_symmetric && (!foundation.exists() || factor.has_foundation());
    const double products    = one_product ? 1. : 2.; // with the matrix, in an iteration
    const double read        = n + counts.entries;
    return {(is_symmetric ? 1. : 2.) * n * time_of_sweep,
            products * read * (read * sizeof(Mat6) <= fits_cache ? time_in_cache : time_of_entry),
            counts.products * time_of_product + counts.fronts * time_of_front + n * time_of_loading,
            is_symmetric};
  }



  LinearSolver::Result LinearSolver::solve_with_factors(const BlockMatrix     &matrix,
                                                        const Eigen::VectorXd &b,
                                                        const Target          &target,
                                                        Eigen::VectorXd       &x)
  {
    if (!keeps_sweeps(matrix))
      release_sweeps();
    const PreconditionerChoice::Costs price = costs(matrix);
    Result                            result;
    const bool                        ready = factor.ready(matrix.n_blocks());
    const int                         old_limit =
      !ready ? 0 : (factor_is_current ? hard_limit : choice.old_factor_limit(price));
    if (old_limit > 0 && (factor_is_current || !factor.is_block_lu()))
      {
        result = solve_with_factor(matrix, b, {target.scale, target.tolerance, old_limit}, x);
        if (!factor_is_current)
          choice.used_old_factor(result.iterations, result.converged, price);
        if (result.converged || factor_is_current)
          {
            choice.solved(result.iterations, 0, price);
            return result;
          }
      }
    const int spent       = result.iterations;
    double    factor_time = 0.;
    {
      const Stopwatch watch(factor_time);
      // A factor of a symmetric matrix serves for long; another one serves once or twice.
      const bool is_joined = is_symmetric && foundation.exists();
      factor_is_current    = factor.factorize(matrix, is_joined ? &foundation : nullptr);
    }
    if (!factor_is_current)
      {
        choice.give_up_factor();
        return solve_by_sweeps(matrix, b, target, x);
      }
    result = solve_with_factor(matrix, b, target, x);
    result.iterations += spent;
    result.factored    = true;
    result.factor_time = factor_time;
    choice.solved(result.iterations, 1, price);
    return result;
  }



  LinearSolver::Result LinearSolver::solve_by_sweeps(const BlockMatrix     &matrix,
                                                     const Eigen::VectorXd &b,
                                                     const Eigen::VectorXd &scale,
                                                     const double           tolerance,
                                                     const int              limit,
                                                     Eigen::VectorXd       &x)
  {
    for (Eigen::VectorXd *work :
         {&x, &unknown, &r, &p, &q, &z, &dual_r, &dual_p, &t, &dual_t, &shadow})
      work->resize(matrix.size());
    is_symmetric = matrix.symmetric;
    return solve_by_sweeps(matrix, b, {scale, tolerance, limit}, x);
  }



  LinearSolver::Result LinearSolver::solve(const BlockMatrix     &matrix,
                                           const Eigen::VectorXd &b,
                                           const Eigen::VectorXd &scale,
                                           const double           tolerance,
                                           Eigen::VectorXd       &x)
  {
    const Eigen::Index size = matrix.size();
    for (Eigen::VectorXd *work : {&x, &unknown, &r, &p, &q, &z})
      work->resize(size);
    if (keeps_sweeps(matrix))
      for (Eigen::VectorXd *work : {&dual_r, &dual_p, &t, &dual_t, &shadow})
        work->resize(size);
    x.setZero();
    is_symmetric = matrix.symmetric;
    Result result;
    result.converged = b.cwiseQuotient(scale).norm() <= tolerance;
    if (result.converged)
      return result;
    if (n_entries < 0.)
      n_entries = count_entries(matrix);
    if (!choice.uses_factor())
      {
        const PreconditionerChoice::Costs price = costs(matrix);
        result = solve_by_sweeps(matrix, b, {scale, tolerance, choice.sweep_limit(price)}, x);
        choice.swept(result.iterations, result.converged, price);
        if (result.converged)
          return result;
      }
    const int spent = result.iterations;
    result          = solve_with_factors(matrix, b, {scale, tolerance, hard_limit}, x);
    result.iterations += spent;
    return result;
  }
} // namespace hybrid::dda
