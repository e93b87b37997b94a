// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/interface_stiffness.h>
#include <hybrid/scene/lapack_band.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybrid::dda
{
  namespace
  {
    /// Entries below this part of the diagonal are left out of the tangent: it may be as much off,
    /// as the residual is not.
    constexpr double small_fraction = 1e-8;

    /// Entries below this part of the diagonal are left out of the factor of blocks and foundation.
    constexpr double near_fraction = 1e-3;

    /// Entries below this part of the diagonal are held in single precision: what that takes of
    /// them (6e-8) is below the round-off of the diagonal.
    constexpr double far_fraction = 1e-9;

    /// Joints and contacts softer than this part of the foundation are left out of its factor.
    constexpr double soft_fraction = 0.1;



    /// Distance from the diagonal beyond which no entry exceeds this @p part of the diagonal.
    int half_band_width(const FoundationStiffness &s, const double fraction)
    {
      const int n = s.size();
      for (int band = s.reach(); band > 0; --band)
        for (int j = 0; j + band < n; ++j)
          if (std::abs(s.column(j)[band]) >
              fraction * std::sqrt(s.column(j)[0] * s.column(j + band)[0]))
            return band;
      return 0;
    }



    /// Entries of a symmetric matrix that are @p first to @p last below the diagonal.
    template <typename Number>
    struct Diagonals
    {
      const Number  *entry; ///< first of the first column
      std::ptrdiff_t leading;
      int            size, first, last;

      /// Entry of @p row in column @p j.
      const Number *at(const int row, const int j) const
      {
        return entry + j * leading + (row - j - first);
      }

      /// y += sign (A + A^T) x for rows @p begin to @p end (excluded) of N columns from @p j on:
      /// with four, y is read and written once for all.
      template <int N>
      void add(const int     j,
               const int     begin,
               const int     end,
               const double  sign,
               const double *x,
               double       *y) const
      {
        const Number *column[N];
        double        factor[N], sum[N];
        for (int c = 0; c < N; ++c)
          {
            column[c] = at(begin, j + c);
            factor[c] = sign * x[j + c];
            sum[c]    = 0.;
          }
        const double *xs = x + begin;
        double       *ys = y + begin;
        if constexpr (N == 4)
          {
            double a = 0., b = 0., c = 0., d = 0.;
#pragma omp simd reduction(+ : a, b, c, d)
            for (int k = 0; k < end - begin; ++k)
              {
                const double p = column[0][k], q = column[1][k], r = column[2][k], s = column[3][k];
                a += p * xs[k];
                b += q * xs[k];
                c += r * xs[k];
                d += s * xs[k];
                ys[k] += (p * factor[0] + q * factor[1]) + (r * factor[2] + s * factor[3]);
              }
            sum[0] = a, sum[1] = b, sum[2] = c, sum[3] = d;
          }
        else
          for (int k = 0; k < end - begin; ++k)
            {
              sum[0] += column[0][k] * xs[k];
              ys[k] += column[0][k] * factor[0];
            }
        for (int c = 0; c < N; ++c)
          y[j + c] += sign * sum[c];
      }

      void add_product(const double sign, const double *x, double *y) const
      {
        for (int j = 0; j < size; j += 4)
          {
            const int  columns = std::min(4, size - j);
            const int  begin   = j + columns - 1 + first; // rows that all of them have
            const int  end     = std::min(size, j + last + 1);
            const bool four    = columns == 4 && begin < end;
            for (int c = 0; c < columns; ++c)
              {
                const int own_begin = std::min(size, j + c + first);
                const int own_end   = std::min(size, j + c + last + 1);
                if (!four)
                  add<1>(j + c, own_begin, std::max(own_begin, own_end), sign, x, y);
                else
                  {
                    add<1>(j + c, own_begin, begin, sign, x, y);
                    add<1>(j + c, end, own_end, sign, x, y);
                  }
              }
            if (four)
              add<4>(j, begin, end, sign, x, y);
          }
      }
    };
  } // namespace



  void InterfaceStiffness::set(const FoundationStiffness &stiffness)
  {
    std::array<double, 4> entries{};
    const int             n = stiffness.size();
    if (n > 0)
      {
        double diagonal = 0.;
        for (int j = 0; j < n; ++j)
          diagonal += stiffness(j, j);
        entries = {static_cast<double>(n), stiffness(0, 0), diagonal, stiffness(n - 1, n - 1)};
      }
    if (stiffness == source && entries == key)
      return;
    source = stiffness;
    key    = entries;
    if (!stiffness.exists())
      return;

    size  = n;
    width = std::min(size - 1, std::max(3, half_band_width(stiffness, small_fraction)));
    near  = std::min(width, half_band_width(stiffness, near_fraction));
    // All entries beyond together are lost in the round-off of a row's product.
    const int reach = half_band_width(stiffness, std::numeric_limits<double>::epsilon() / size);
    const int edge  = std::max(width, half_band_width(stiffness, far_fraction));
    band            = Eigen::MatrixXd::Zero(edge + 1, size);
    far             = Eigen::MatrixXf::Zero(std::max(0, reach - edge), size);
    for (int j = 0; j < size; ++j)
      for (int below = 0; below <= reach && j + below < size; ++below)
        if (below <= edge)
          band(below, j) = stiffness(j + below, j);
        else
          far(below - edge - 1, j) = static_cast<float>(stiffness(j + below, j));
    foundation_factor = band.topRows(width + 1);
    joined            = false;
    if (!factorize(foundation_factor))
      {
        // The band is not definite by itself: fall back to the diagonal.
        foundation_factor.setZero();
        for (int j = 0; j < size; ++j)
          foundation_factor(0, j) = std::sqrt(stiffness(j, j));
      }
  }



  bool InterfaceStiffness::factorize(Eigen::MatrixXd &matrix) const
  {
    const int leading = width + 1;
    int       info    = 0;
    dpbtrf_("L", &size, &width, matrix.data(), &leading, &info);
    return info == 0;
  }



  void InterfaceStiffness::matrix_changed(const BlockMatrix &matrix)
  {
    joined = false;
    if (!source.exists())
      return;
    const int m = matrix.n_nodes();
    for (int k = 0; k < m; ++k)
      for (int c = 0; c < 2; ++c)
        joined = joined || matrix.node_diagonal[k](c, c) > soft_fraction * band(0, 2 * k + c);
    if (!joined)
      return;
    own.resize(m);
    next.resize(m);
    joined_factor = band.topRows(width + 1);
    for (int k = 0; k < m; ++k)
      {
        const Eigen::Matrix2d &d = matrix.node_diagonal[k];
        own[k]                   = 0.5 * (d + d.transpose());
        joined_factor(0, 2 * k) += own[k](0, 0);
        joined_factor(1, 2 * k) += own[k](1, 0);
        joined_factor(0, 2 * k + 1) += own[k](1, 1);
        next[k].setZero();
        if (k + 1 == m)
          continue;
        next[k] = 0.5 * (matrix.node_next[k] + matrix.node_previous[k].transpose());
        for (int c = 0; c < 2; ++c)
          for (int r = 0; r < 2; ++r)
            joined_factor(2 + r - c, 2 * k + c) += next[k](c, r);
      }
    joined = factorize(joined_factor); // not definite while joints soften: S alone
  }



  void InterfaceStiffness::add_product(const double *x, double *y) const
  {
    if (!source.exists())
      return;
    for (int j = 0; j < size; ++j)
      y[j] += band(0, j) * x[j];
    Diagonals<double>{band.data() + 1, band.rows(), size, 1, width}.add_product(1., x, y);
  }



  void InterfaceStiffness::subtract_whole_product(const double *x, double *y) const
  {
    if (!source.exists())
      return;
    const int edge = static_cast<int>(band.rows()) - 1, reach = edge + static_cast<int>(far.rows());
    for (int j = 0; j < size; ++j)
      y[j] -= band(0, j) * x[j];
    Diagonals<double>{band.data() + 1, band.rows(), size, 1, edge}.add_product(-1., x, y);
    if (reach > edge)
      Diagonals<float>{far.data(), far.rows(), size, edge + 1, reach}.add_product(-1., x, y);
  }



  void InterfaceStiffness::add_nodes(const double *x, double *y, const double sign) const
  {
    if (!joined)
      return;
    for (std::size_t k = 0; k < own.size(); ++k)
      {
        const Eigen::Map<const Eigen::Vector2d> here(x + 2 * k);
        Eigen::Map<Eigen::Vector2d>(y + 2 * k) += sign * own[k] * here;
        if (k + 1 == own.size())
          break;
        const Eigen::Map<const Eigen::Vector2d> after(x + 2 * k + 2);
        Eigen::Map<Eigen::Vector2d>(y + 2 * k) += sign * next[k] * after;
        Eigen::Map<Eigen::Vector2d>(y + 2 * k + 2) += sign * next[k].transpose() * here;
      }
  }



  void InterfaceStiffness::diagonal(Eigen::Ref<Eigen::VectorXd> d) const
  {
    d.setOnes();
    if (!source.exists())
      return;
    d = band.row(0).transpose();
    if (joined)
      for (std::size_t k = 0; k < own.size(); ++k)
        d.segment<2>(2 * k) += own[k].diagonal();
  }



  void InterfaceStiffness::solve_with(const Eigen::MatrixXd &factor, double *x) const
  {
    if (!source.exists() || size == 0)
      return;
    const int leading = width + 1, one = 1;
    int       info = 0;
    dpbtrs_("L", &size, &width, &one, factor.data(), &leading, x, &size, &info);
  }



  void InterfaceStiffness::solve(double *x) const
  {
    solve_with(joined ? joined_factor : foundation_factor, x);
  }



  void InterfaceStiffness::solve_alone(double *x) const
  {
    solve_with(foundation_factor, x);
  }
} // namespace hybrid::dda
