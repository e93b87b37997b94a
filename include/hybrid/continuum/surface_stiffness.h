// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace hybrid::continuum
{
  /// The dynamic stiffness S of the unknowns of the contact surface, symmetric [N/m per m].
  struct SurfaceStiffness
  {
    Eigen::MatrixXd entries;         ///< all of them, or rows r of a band: S(j + r, j) in column j
    bool            is_band = false; ///< entries beyond are round-off

    /// y += S x.
    void add_product(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
    {
      if (!is_band)
        {
          y.noalias() += entries * x;
          return;
        }
      const Eigen::Index n = entries.cols();
      for (Eigen::Index j = 0; j < n; ++j)
        {
          const Eigen::Index below = std::min(entries.rows(), n - j) - 1;
          y[j] +=
            entries(0, j) * x[j] + entries.col(j).segment(1, below).dot(x.segment(j + 1, below));
          y.segment(j + 1, below) += entries.col(j).segment(1, below) * x[j];
        }
    }

    Eigen::MatrixXd dense() const
    {
      if (!is_band)
        return entries;
      const Eigen::Index n = entries.cols();
      Eigen::MatrixXd    s = Eigen::MatrixXd::Zero(n, n);
      for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index r = 0; r < entries.rows() && j + r < n; ++r)
          s(j + r, j) = s(j, j + r) = entries(r, j);
      return s;
    }
  };
} // namespace hybrid::continuum
