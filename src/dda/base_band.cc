// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/base_band.h>

#include <algorithm>
#include <cmath>

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
    /// Entries below this part of the diagonal are lost in round-off anyway.
    constexpr double round_off = 1e-16;



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



  void BaseBand::set(const Eigen::MatrixXd *stiffness)
  {
    std::vector<double> entries;
    if (stiffness != nullptr && stiffness->rows() > 0)
      entries = {static_cast<double>(stiffness->rows()),
                 (*stiffness)(0, 0),
                 stiffness->diagonal().sum(),
                 (*stiffness)(stiffness->rows() - 1, stiffness->rows() - 1)};
    if (stiffness == source && entries == key)
      return;
    source = stiffness;
    key    = entries;
    if (stiffness == nullptr)
      return;

    size  = static_cast<int>(stiffness->rows());
    width = half_band_width(*stiffness);
    band  = Eigen::MatrixXd::Zero(width + 1, size);
    for (int j = 0; j < size; ++j)
      for (int below = 0; below <= width && j + below < size; ++below)
        band(below, j) = (*stiffness)(j + below, j);
    factor            = band;
    const int leading = width + 1;
    int       info    = 0;
    dpbtrf_("L", &size, &width, factor.data(), &leading, &info);
    if (info != 0)
      {
        // The band is not definite by itself: fall back to the diagonal.
        factor.setZero();
        for (int j = 0; j < size; ++j)
          factor(0, j) = std::sqrt((*stiffness)(j, j));
      }
  }



  void BaseBand::add_product(const double *x, double *y) const
  {
    if (source == nullptr)
      return;
    for (int j = 0; j < size; ++j)
      {
        const double *column = band.data() + static_cast<std::ptrdiff_t>(j) * (width + 1);
        const double  xj     = x[j];
        const int     last   = std::min(width, size - 1 - j);
        double        sum    = column[0] * xj;
        for (int below = 1; below <= last; ++below)
          {
            sum += column[below] * x[j + below];
            y[j + below] += column[below] * xj;
          }
        y[j] += sum;
      }
  }



  void BaseBand::solve(double *x) const
  {
    if (source == nullptr || size == 0)
      return;
    const int leading = width + 1, one = 1;
    int       info = 0;
    dpbtrs_("L", &size, &width, &one, factor.data(), &leading, x, &size, &info);
  }
} // namespace hybrid::dda
