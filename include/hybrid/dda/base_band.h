// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /// The base's own stiffness S, kept as a band with its Cholesky factor.
  class BaseBand
  {
  public:
    /// @p stiffness (n x n, symmetric positive definite) for the next steps; nullptr: none. Entries
    /// below round-off are dropped. Nothing is done if it is the same as before.
    void set(const Eigen::MatrixXd *stiffness);

    bool exists() const
    {
      return source != nullptr;
    }

    /// y += S x for n entries.
    void add_product(const double *x, double *y) const;

    /// x = S^-1 x for n entries; without a base x stays.
    void solve(double *x) const;

  private:
    const Eigen::MatrixXd *source = nullptr;
    std::vector<double> key; ///< a few entries of S, to notice another matrix at the same address
    int                 size  = 0;
    int                 width = 0; ///< half band width of S
    Eigen::MatrixXd     band;      ///< rows 0..width: S(j + r, j), LAPACK lower band storage
    Eigen::MatrixXd     factor;    ///< its Cholesky factor, same storage
  };
} // namespace hybrid::dda
