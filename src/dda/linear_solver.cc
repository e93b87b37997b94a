// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear_solver.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    constexpr int swept_limit  = 40; ///< iterations with sweeps before a factor is made
    constexpr int factor_limit = 12; ///< iterations with an old factor before a new one is made
    constexpr int hard_limit   = 2000;
  } // namespace



  void LinearSolver::matrix_changed(const BlockMatrix &matrix)
  {
    factor_is_current = false;
    swept.set(matrix, base);
  }



  void LinearSolver::multiply(const BlockMatrix     &matrix,
                              const Eigen::VectorXd &x,
                              Eigen::VectorXd       &y) const
  {
    matrix.multiply(x, y);
    const int nodes = 6 * matrix.n_blocks();
    base.add_product(x.data() + nodes, y.data() + nodes);
  }



  void LinearSolver::precondition(const BlockMatrix &matrix, const Eigen::VectorXd &residual)
  {
    const int nodes = 6 * matrix.n_blocks();
    factor.solve(residual, z);
    z.tail(z.size() - nodes) = residual.tail(z.size() - nodes);
    base.solve(z.data() + nodes);
  }



  LinearSolver::Result LinearSolver::conjugate_gradients(const Target &target)
  {
    Result result;
    p          = r;
    dual_p     = dual_r;
    double rho = r.dot(dual_r);
    while (result.iterations < target.limit)
      {
        ++result.iterations;
        swept.multiply(p, q);
        const double alpha = rho / dual_p.dot(q);
        if (!(alpha > 0.) || !std::isfinite(alpha))
          return result;
        unknown += alpha * p;
        r -= alpha * q;
        swept.multiply_diagonal(r, dual_r);
        if (target.met_by(dual_r))
          {
            result.converged = true;
            return result;
          }
        const double next = r.dot(dual_r);
        p                 = r + (next / rho) * p;
        dual_p            = dual_r + (next / rho) * dual_p;
        rho               = next;
      }
    return result;
  }



  template <typename System>
  LinearSolver::Result LinearSolver::stabilised_gradients(System &system, const Target &target)
  {
    Result result;
    shadow     = dual_r;
    double rho = r.dot(shadow);
    p          = r;
    while (result.iterations < target.limit)
      {
        ++result.iterations;
        system.multiply(p, q);
        const double alpha = rho / q.dot(shadow);
        if (!std::isfinite(alpha))
          return result;
        unknown += alpha * p;
        r -= alpha * q;
        system.dual(r, dual_r);
        if (target.met_by(dual_r))
          {
            result.converged = true;
            return result;
          }
        system.multiply(r, t);
        system.dual(t, dual_t);
        const double omega = t.dot(dual_r) / t.dot(dual_t);
        if (!std::isfinite(omega) || omega == 0.)
          return result;
        unknown += omega * r;
        r -= omega * t;
        dual_r -= omega * dual_t;
        if (target.met_by(dual_r))
          {
            result.converged = true;
            return result;
          }
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
  LinearSolver::solve_swept(const bool symmetric, const Target &target, Eigen::VectorXd &x)
  {
    struct System
    {
      SweptSystem &swept;

      void multiply(const Eigen::VectorXd &v, Eigen::VectorXd &product)
      {
        swept.multiply(v, product);
      }

      void dual(const Eigen::VectorXd &v, Eigen::VectorXd &image) const
      {
        swept.multiply_diagonal(v, image);
      }
    };
    System system{swept};
    swept.sweep_forward(r, r);
    system.dual(r, dual_r);
    const Result result =
      symmetric ? conjugate_gradients(target) : stabilised_gradients(system, target);
    swept.sweep_backward(unknown, x);
    return result;
  }



  LinearSolver::Result LinearSolver::solve_with_factor(const BlockMatrix &matrix,
                                                       const Target      &target,
                                                       Eigen::VectorXd   &x)
  {
    struct System
    {
      LinearSolver      &solver;
      const BlockMatrix &matrix;

      void multiply(const Eigen::VectorXd &v, Eigen::VectorXd &product)
      {
        solver.precondition(matrix, v);
        solver.multiply(matrix, solver.z, product);
      }

      void dual(const Eigen::VectorXd &v, Eigen::VectorXd &image) const
      {
        image = v;
      }
    };
    System system{*this, matrix};
    dual_r              = r;
    const Result result = stabilised_gradients(system, target);
    precondition(matrix, unknown);
    x = z;
    return result;
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
                        : solve_swept(matrix.symmetric, target, x);
    };
    use_factor = use_factor && factor.ready(matrix.n_blocks());
    result     = attempt(use_factor ? factor_limit : swept_limit);
    if (result.converged)
      return result;

    const int spent    = result.iterations;
    bool      factored = false;
    if (!factor_is_current || !use_factor)
      factored = use_factor = factor_is_current = factor.factorize(matrix);
    result = attempt(hard_limit);
    result.iterations += spent;
    result.factored = factored;
    return result;
  }
} // namespace hybrid::dda
