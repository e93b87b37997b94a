// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear_solver.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

extern "C"
{
  // LAPACK: Cholesky factorisation and solve of a symmetric band matrix.
  void
  dpbtrf_(const char *uplo, const int *n, const int *kd, double *ab, const int *ldab, int *info);
  void dpbtrs_(const char   *uplo,
               const int    *n,
               const int    *kd,
               const int    *nrhs,
               const double *ab,
               const int    *ldab,
               double       *b,
               const int    *ldb,
               int          *info);
}

namespace hybrid::dda
{
  namespace
  {
    constexpr int diagonal_limit = 60; ///< iterations with diagonal blocks before a factor is made
    constexpr int factor_limit   = 12; ///< iterations with an old factor before a new one is made
    constexpr int hard_limit     = 2000;

    /// Entries below this part of the diagonal are lost in round-off anyway.
    constexpr double round_off = 1e-16;



    double weighted_norm(const Eigen::VectorXd &v, const Eigen::VectorXd &scale)
    {
      return v.cwiseQuotient(scale).norm();
    }



    int half_band_width(const Eigen::MatrixXd &s)
    {
      const int n = static_cast<int>(s.rows());
      for (int band = n - 1; band > 0; --band)
        for (int j = 0; j + band < n; ++j)
          if (std::abs(s(j + band, j)) > round_off * std::sqrt(s(j, j) * s(j + band, j + band)))
            return band;
      return 0;
    }
  } // namespace



  void LinearSolver::set_base_stiffness(const Eigen::MatrixXd *stiffness)
  {
    std::vector<double> key;
    if (stiffness != nullptr && stiffness->rows() > 0)
      key = {static_cast<double>(stiffness->rows()),
             (*stiffness)(0, 0),
             stiffness->diagonal().sum(),
             (*stiffness)(stiffness->rows() - 1, stiffness->rows() - 1)};
    if (stiffness == base_source && key == base_key)
      return;
    base_source = stiffness;
    base_key    = key;
    if (stiffness == nullptr)
      return;

    const int n = static_cast<int>(stiffness->rows());
    band        = half_band_width(*stiffness);
    base_band   = Eigen::MatrixXd::Zero(band + 1, n);
    for (int j = 0; j < n; ++j)
      for (int below = 0; below <= band && j + below < n; ++below)
        base_band(below, j) = (*stiffness)(j + below, j);
    base_factor       = base_band;
    const int leading = band + 1;
    int       info    = 0;
    dpbtrf_("L", &n, &band, base_factor.data(), &leading, &info);
    if (info != 0)
      {
        // The band is not definite by itself: fall back to the diagonal.
        base_factor.setZero();
        for (int j = 0; j < n; ++j)
          base_factor(0, j) = std::sqrt((*stiffness)(j, j));
      }
  }



  void LinearSolver::matrix_changed(const BlockMatrix &matrix)
  {
    factor_is_current = false;
    inverse_diagonal.resize(matrix.n_blocks());
#pragma omp parallel for schedule(static)
    for (int i = 0; i < matrix.n_blocks(); ++i)
      inverse_diagonal[i] = matrix.diagonal[i].partialPivLu().inverse();
  }



  void LinearSolver::multiply(const BlockMatrix     &matrix,
                              const Eigen::VectorXd &x,
                              Eigen::VectorXd       &y) const
  {
    matrix.multiply(x, y);
    if (base_source == nullptr)
      return;
    const int     n = 2 * matrix.n_nodes(), offset = 6 * matrix.n_blocks();
    const double *in  = x.data() + offset;
    double       *out = y.data() + offset;
    for (int j = 0; j < n; ++j)
      {
        const double *column = base_band.data() + static_cast<std::ptrdiff_t>(j) * (band + 1);
        const double  xj     = in[j];
        const int     last   = std::min(band, n - 1 - j);
        double        sum    = column[0] * xj;
        for (int below = 1; below <= last; ++below)
          {
            sum += column[below] * in[j + below];
            out[j + below] += column[below] * xj;
          }
        out[j] += sum;
      }
  }



  void LinearSolver::precondition(const Eigen::VectorXd &residual, Eigen::VectorXd &result)
  {
    const int n = static_cast<int>(inverse_diagonal.size());
    if (use_factor)
      factor.solve(residual, result);
    else
      {
#pragma omp parallel for schedule(static)
        for (int i = 0; i < n; ++i)
          Eigen::Map<Vec6>(result.data() + 6 * i).noalias() =
            inverse_diagonal[i] * Eigen::Map<const Vec6>(residual.data() + 6 * i);
      }
    const int m = static_cast<int>(residual.size()) - 6 * n;
    if (m == 0)
      return;
    std::copy_n(residual.data() + 6 * n, m, result.data() + 6 * n);
    if (base_source == nullptr)
      return;
    const int leading = band + 1, one = 1;
    int       info = 0;
    dpbtrs_("L", &m, &band, &one, base_factor.data(), &leading, result.data() + 6 * n, &m, &info);
  }



  LinearSolver::Result LinearSolver::conjugate_gradients(const BlockMatrix     &matrix,
                                                         const Eigen::VectorXd &scale,
                                                         const double           tolerance,
                                                         const int              limit,
                                                         Eigen::VectorXd       &x)
  {
    Result result;
    precondition(r, z);
    p          = z;
    double rho = r.dot(z);
    while (result.iterations < limit)
      {
        ++result.iterations;
        multiply(matrix, p, q);
        const double alpha = rho / p.dot(q);
        if (!(alpha > 0.) || !std::isfinite(alpha))
          return result;
        x += alpha * p;
        r -= alpha * q;
        if (weighted_norm(r, scale) <= tolerance)
          {
            result.converged = true;
            return result;
          }
        precondition(r, z);
        const double next = r.dot(z);
        p                 = z + (next / rho) * p;
        rho               = next;
      }
    return result;
  }



  LinearSolver::Result LinearSolver::stabilised_gradients(const BlockMatrix     &matrix,
                                                          const Eigen::VectorXd &scale,
                                                          const double           tolerance,
                                                          const int              limit,
                                                          Eigen::VectorXd       &x)
  {
    // BiCGStab (van der Vorst 1992), preconditioned from the right.
    Result result;
    shadow     = r;
    double rho = r.dot(shadow);
    p          = r;
    while (result.iterations < limit)
      {
        ++result.iterations;
        precondition(p, z);
        multiply(matrix, z, q);
        const double alpha = rho / q.dot(shadow);
        if (!std::isfinite(alpha))
          return result;
        x += alpha * z;
        r -= alpha * q;
        if (weighted_norm(r, scale) <= tolerance)
          {
            result.converged = true;
            return result;
          }
        precondition(r, z);
        multiply(matrix, z, t);
        const double omega = t.dot(r) / t.squaredNorm();
        if (!std::isfinite(omega) || omega == 0.)
          return result;
        x += omega * z;
        r -= omega * t;
        if (weighted_norm(r, scale) <= tolerance)
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



  LinearSolver::Result LinearSolver::iterate(const BlockMatrix     &matrix,
                                             const Eigen::VectorXd &b,
                                             const Eigen::VectorXd &scale,
                                             const double           tolerance,
                                             const int              limit,
                                             Eigen::VectorXd       &x)
  {
    x.setZero();
    r = b;
    if (weighted_norm(r, scale) <= tolerance)
      {
        Result result;
        result.converged = true;
        return result;
      }
    return matrix.symmetric ? conjugate_gradients(matrix, scale, tolerance, limit, x)
                            : stabilised_gradients(matrix, scale, tolerance, limit, x);
  }


  LinearSolver::Result LinearSolver::solve(const BlockMatrix     &matrix,
                                           const Eigen::VectorXd &b,
                                           const Eigen::VectorXd &scale,
                                           const double           tolerance,
                                           Eigen::VectorXd       &x)
  {
    const int size = matrix.size();
    x.resize(size);
    r.resize(size);
    z.resize(size);
    p.resize(size);
    q.resize(size);
    t.resize(size);
    shadow.resize(size);

    int spent  = 0;
    use_factor = use_factor && factor.ready(matrix.n_blocks());
    Result result =
      iterate(matrix, b, scale, tolerance, use_factor ? factor_limit : diagonal_limit, x);
    if (result.converged)
      return result;

    spent = result.iterations;
    if (!factor_is_current || !use_factor)
      {
        use_factor        = factor.factorize(matrix);
        factor_is_current = use_factor;
        result.factored   = use_factor;
      }
    const bool factored = result.factored;
    result              = iterate(matrix, b, scale, tolerance, hard_limit, x);
    result.iterations += spent;
    result.factored = factored;
    return result;
  }
} // namespace hybrid::dda
