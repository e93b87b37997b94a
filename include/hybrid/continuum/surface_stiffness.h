// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace hybrid::continuum
{
  /// The dynamic stiffness S of the unknowns of the contact surface, symmetric [N/m per m].
  struct SurfaceStiffness
  {
    Eigen::MatrixXd entries;         ///< all of them, or rows r of a band: S(j + r, j) in column j
    bool            is_band = false; ///< entries beyond are round-off

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
