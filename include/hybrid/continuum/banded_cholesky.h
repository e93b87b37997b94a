// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace hybrid::continuum
{
  /// Symmetric positive definite band matrix: assemble, factor A = L L^T in place, solve.
  class BandedCholesky
  {
  public:
    BandedCholesky() = default;

    /// @param half_width entries (i, j) with |i - j| <= half_width exist.
    BandedCholesky(int size, int half_width);

    /// Entry of the lower triangle, i >= j >= i - half_width.
    double &operator()(int i, int j)
    {
      return band[static_cast<std::size_t>(i) * (width + 1) + (j - i + width)];
    }

    double operator()(int i, int j) const
    {
      return band[static_cast<std::size_t>(i) * (width + 1) + (j - i + width)];
    }

    /// @throws std::runtime_error if a pivot is not positive.
    void factor();

    /// x := A^-1 x after factor().
    void solve(std::vector<double> &x) const;

  private:
    int                 n = 0, width = 0;
    std::vector<double> band; ///< rows of the lower triangle, diagonal last
  };
} // namespace hybrid::continuum
