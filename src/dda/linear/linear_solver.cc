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
    constexpr int factor_limit = 12; ///< iterations with an old factor before a new one is made
    constexpr int hard_limit   = 2000;
    constexpr int few_failures = 2; ///< of old factors in a row, after which they are passed over
    constexpr int retry_every  = 8; ///< matrices, to see if an old factor serves again
    constexpr int few_factors  = 4; ///< half of those made before sweeps are tried again
    constexpr int many_factors = 512;



    /// Iterations with sweeps before a factor is made: its work grows as n^(3/2) (George 1973),
    /// that of a sweep as n.
    int sweep_limit(const int n_blocks)
    {
      return std::max(40, static_cast<int>(0.8 * std::sqrt(n_blocks)));
    }
  } // namespace



  void LinearSolver::matrix_changed(const BlockMatrix &matrix, const std::vector<int> &blocks)
  {
    factor_is_current = false;
    foundation.matrix_changed(matrix);
    ssor.set(matrix, foundation, blocks);
  }



  void LinearSolver::matrix_restored(const BlockMatrix &matrix)
  {
    foundation.matrix_changed(matrix);
    ssor.set(matrix, foundation, {});
  }



  void LinearSolver::serialize(restart::Archive &archive, const BlockMatrix &matrix)
  {
    archive(use_factor, factor_is_current, failures, passed_over, factors_before_retry, factors);
    factor.serialize(archive, matrix);
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
    z.tail(z.size() - nodes) = residual.tail(z.size() - nodes);
    matrix.add_blocks_to_nodes(z, z, -1.);
    foundation.solve(z.data() + nodes);
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
        unknown += alpha * p;
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
        unknown += omega * r;
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



  LinearSolver::Result
  LinearSolver::solve_by_sweeps(const bool symmetric, const Target &target, Eigen::VectorXd &x)
  {
    Preconditioned system{*this, target};
    ssor.sweep_forward(r, r);
    const Result result =
      symmetric ? conjugate_gradients(system, target.limit) : bicgstab(system, target.limit);
    ssor.sweep_backward(unknown, x);
    return result;
  }



  LinearSolver::Result LinearSolver::solve_with_factor(const BlockMatrix &matrix,
                                                       const Target      &target,
                                                       Eigen::VectorXd   &x)
  {
    Factored     system{*this, matrix, target};
    const Result result = bicgstab(system, target.limit);
    precondition(matrix, unknown);
    x = z;
    return result;
  }



  bool LinearSolver::are_sweeps_due() const
  {
    return !factor_is_current && !factor.is_cheap() && factors >= factors_before_retry;
  }



  void LinearSolver::judge_sweeps(const bool served)
  {
    factors_before_retry = served ? few_factors : std::min(2 * factors_before_retry, many_factors);
    factors              = 0;
  }



  bool LinearSolver::is_worth_trying()
  {
    if (factor_is_current)
      return true;
    if (factor.is_cheap())
      return false;
    if (failures < few_failures)
      return true;
    passed_over = (passed_over + 1) % retry_every;
    return passed_over == 0;
  }



  LinearSolver::Result LinearSolver::solve(const BlockMatrix     &matrix,
                                           const Eigen::VectorXd &b,
                                           const Eigen::VectorXd &scale,
                                           const double           tolerance,
                                           Eigen::VectorXd       &x)
  {
    const Eigen::Index size = matrix.size();
    for (Eigen::VectorXd *work : {&x, &unknown, &r, &dual_r, &p, &dual_p, &q, &t, &dual_t, &z})
      work->resize(size);
    x.setZero();
    Result result;
    result.converged = b.cwiseQuotient(scale).norm() <= tolerance;
    if (result.converged)
      return result;

    const auto attempt = [&](const int limit) {
      const Target target{scale, tolerance, limit};
      unknown.setZero();
      r = b;
      return use_factor ? solve_with_factor(matrix, target, x)
                        : solve_by_sweeps(matrix.symmetric, target, x);
    };
    use_factor = use_factor && factor.ready(matrix.n_blocks()) && !are_sweeps_due();
    if (!use_factor || is_worth_trying())
      {
        result = attempt(use_factor ? factor_limit : sweep_limit(matrix.n_blocks()));
        if (use_factor && !factor_is_current)
          failures = result.converged ? 0 : failures + 1;
        if (!use_factor)
          judge_sweeps(result.converged);
        if (result.converged)
          return result;
      }

    const int spent       = result.iterations;
    bool      factored    = false;
    double    factor_time = 0.;
    if (!factor_is_current || !use_factor)
      {
        const Stopwatch watch(factor_time);
        factored = use_factor = factor_is_current = factor.factorize(matrix);
        ++factors;
      }
    result = attempt(hard_limit);
    result.iterations += spent;
    result.factored    = factored;
    result.factor_time = factor_time;
    return result;
  }
} // namespace hybrid::dda
