// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/banded_cholesky.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hybrid::continuum
{
  BandedCholesky::BandedCholesky(const int size, const int half_width)
    : n(size)
    , width(half_width)
    , band(static_cast<std::size_t>(size) * (half_width + 1), 0.)
  {}


  void BandedCholesky::factor()
  {
    auto &l = *this;
    for (int i = 0; i < n; ++i)
      for (int j = std::max(0, i - width); j <= i; ++j)
        {
          double sum = l(i, j);
          for (int k = std::max(0, i - width); k < j; ++k)
            sum -= l(i, k) * l(j, k);
          if (j < i)
            l(i, j) = sum / l(j, j);
          else if (sum > 0.)
            l(i, i) = std::sqrt(sum);
          else
            throw std::runtime_error("BandedCholesky: the matrix is not positive definite");
        }
  }


  void BandedCholesky::solve(std::vector<double> &x) const
  {
    const auto &l = *this;
    for (int i = 0; i < n; ++i)
      {
        for (int k = std::max(0, i - width); k < i; ++k)
          x[i] -= l(i, k) * x[k];
        x[i] /= l(i, i);
      }
    for (int i = n - 1; i >= 0; --i)
      {
        x[i] /= l(i, i);
        for (int k = std::max(0, i - width); k < i; ++k)
          x[k] -= l(i, k) * x[i];
      }
  }
} // namespace hybrid::continuum
