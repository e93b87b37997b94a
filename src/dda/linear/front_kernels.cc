// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/block_inverse.h>
#include <hybrid/dda/linear/front_kernels.h>

#include <algorithm>

extern "C"
{
  // BLAS: C = beta C + alpha A B.
  void dgemm_(const char   *trans_a,
              const char   *trans_b,
              const int    *m,
              const int    *n,
              const int    *k,
              const double *alpha,
              const double *a,
              const int    *lda,
              const double *b,
              const int    *ldb,
              const double *beta,
              double       *c,
              const int    *ldc);
  // BLAS: y = beta y + alpha A x.
  void dgemv_(const char   *trans,
              const int    *m,
              const int    *n,
              const double *alpha,
              const double *a,
              const int    *lda,
              const double *x,
              const int    *inc_x,
              const double *beta,
              double       *y,
              const int    *inc_y);
  // BLAS: B = alpha B A^-1 (side R) of a triangular A.
  void dtrsm_(const char   *side,
              const char   *part,
              const char   *trans,
              const char   *diagonal,
              const int    *m,
              const int    *n,
              const double *alpha,
              const double *a,
              const int    *lda,
              double       *b,
              const int    *ldb);
  // LAPACK: LU factors of a matrix, and the solution from them.
  void dgetrf_(const int *m, const int *n, double *a, const int *lda, int *pivots, int *info);
  void dgetrs_(const char   *trans,
               const int    *n,
               const int    *columns,
               const double *factors,
               const int    *lda,
               const int    *pivots,
               double       *b,
               const int    *ldb,
               int          *info);
}

namespace hybrid::dda
{
  namespace
  {
    /// Columns of a large product, or rows of a large quotient, that a thread takes at a time;
    /// operations from which it is large: 100 us.
    constexpr int    columns_of_thread = 96;
    constexpr int    rows_of_thread    = 96;
    constexpr double large_product     = 4e6;

    /// Entries of a matrix from which its product with a vector is BLAS's.
    constexpr int entries_of_blas = 1500;

    /// Columns of a symmetric product that are computed down from the same row.
    constexpr int columns_of_triangle = 48;

    void call_blas(const char       trans_b,
                   const double     alpha,
                   const DenseView &a,
                   const DenseView &b,
                   const double     beta,
                   const DenseView &c)
    {
      dgemm_("N",
             &trans_b,
             &c.rows,
             &c.columns,
             &a.columns,
             &alpha,
             a.data,
             &a.stride,
             b.data,
             &b.stride,
             &beta,
             c.data,
             &c.stride);
    }



    bool is_for_blas(const DenseView &a)
    {
      return a.columns > 6 && a.rows * a.columns >= entries_of_blas;
    }



    /// y = beta y + alpha A x, or of the transpose.
    void call_blas(const char       trans,
                   const double     alpha,
                   const DenseView &a,
                   const double    *x,
                   const double     beta,
                   double          *y)
    {
      constexpr int one = 1;
      dgemv_(&trans, &a.rows, &a.columns, &alpha, a.data, &a.stride, x, &one, &beta, y, &one);
    }



    void copy_matrix(const DenseView &from, const DenseView &to)
    {
      for (int j = 0; j < from.columns; ++j)
        std::copy_n(from.at(0, j), from.rows, to.at(0, j));
    }



    bool is_finite(const DenseView &a)
    {
      for (int j = 0; j < a.columns / 6; ++j)
        for (int i = 0; i < a.rows / 6; ++i)
          if (!a.block(i, j).allFinite())
            return false;
      return true;
    }



    Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> matrix(const DenseView &a)
    {
      return {a.data, a.rows, a.columns, Eigen::OuterStride<>(a.stride)};
    }



    /// X = X D^-1 by the factors of D.
    void divide_by_factors(const DenseView &x, const DenseDivisor &d)
    {
      constexpr double one    = 1.;
      const DenseView &lu     = d.matrix;
      const auto       divide = [&](const char part, const char diagonal) {
        dtrsm_("R",
               &part,
               "N",
               &diagonal,
               &x.rows,
               &x.columns,
               &one,
               lu.data,
               &lu.stride,
               x.data,
               &x.stride);
      };
      divide('U', 'N');
      divide('L', 'U');
      for (int j = x.columns - 1; j >= 0; --j)
        if (const int other = d.pivots[j] - 1; other != j)
          std::swap_ranges(x.at(0, j), x.at(0, j) + x.rows, x.at(0, other));
    }



    /// As DenseInverse::invert(), without a second try. @param work a.rows^2 / 2 entries
    bool
    invert_halves(const DenseView &a, const double *largest, double *work) // NOLINT(*-no-recursion)
    {
      const int n = a.rows;
      if (n == 6)
        {
          Eigen::Map<Mat6, 0, Eigen::OuterStride<>> here = a.block(0, 0);
          if (!(here.cwiseAbs().maxCoeff() <= *largest))
            return false;
          here = block_inverse(here);
          return true;
        }
      // [P Q; R S]: with T = S - R P^-1 Q the inverse is
      // [P^-1 + P^-1 Q T^-1 R P^-1, -P^-1 Q T^-1; -T^-1 R P^-1, T^-1].
      const int       m = n / 12 * 6, k = n - m;
      const DenseView p = a.part(0, 0, m, m), q = a.part(0, m, m, k), r = a.part(m, 0, k, m),
                      s     = a.part(m, m, k, k);
      const DenseView below = {work, k, m, k}, right = {work + k * m, m, k, m};
      if (!invert_halves(p, largest, work))
        return false;
      multiply(1., r, p, 0., below);
      copy_matrix(below, r);
      multiply(-1., r, q, 1., s);
      if (!invert_halves(s, largest + m / 6, work))
        return false;
      multiply(1., p, q, 0., right);
      multiply(-1., right, s, 0., q);
      multiply(-1., s, r, 0., below);
      copy_matrix(below, r);
      multiply(-1., right, r, 1., p);
      return true;
    }
  } // namespace



  void multiply(const double     alpha,
                const DenseView &a,
                const DenseView &b,
                const double     beta,
                const DenseView &c)
  {
    if (c.rows == 6 && c.columns == 6 && a.columns == 6)
      {
        const Mat6 product = alpha * a.block(0, 0) * b.block(0, 0);
        if (beta == 0.)
          c.block(0, 0) = product;
        else
          c.block(0, 0) = beta * c.block(0, 0) + product;
        return;
      }
    if (c.columns < 2 * columns_of_thread || 2. * c.rows * c.columns * a.columns < large_product)
      {
        call_blas('N', alpha, a, b, beta, c);
        return;
      }
#pragma omp parallel for schedule(dynamic)
    for (int j = 0; j < c.columns; j += columns_of_thread)
      {
        const int n = std::min(columns_of_thread, c.columns - j);
        call_blas('N', alpha, a, b.part(0, j, b.rows, n), beta, c.part(0, j, c.rows, n));
      }
  }



  void subtract_lower(const DenseView &a, const DenseView &b, const DenseView &c)
  {
    const int n = c.columns;
#pragma omp parallel for schedule(dynamic) if (1. * n * n * a.columns >= large_product)
    for (int j = 0; j < n; j += columns_of_triangle)
      {
        const int m = std::min(columns_of_triangle, n - j);
        call_blas('T',
                  -1.,
                  a.part(j, 0, n - j, a.columns),
                  b.part(j, 0, m, b.columns),
                  1.,
                  c.part(j, j, n - j, m));
      }
  }



  void subtract_product(const DenseView &a, const double *x, double *y)
  {
    if (is_for_blas(a))
      return call_blas('N', -1., a, x, 1., y);
    for (int j = 0; j < a.columns / 6; ++j)
      {
        const Vec6 part = Eigen::Map<const Vec6>(x + 6 * j);
        for (int i = 0; i < a.rows / 6; ++i)
          Eigen::Map<Vec6>(y + 6 * i).noalias() -= a.block(i, j) * part;
      }
  }



  void subtract_transposed_product(const DenseView &a, const double *x, double *y)
  {
    if (is_for_blas(a))
      return call_blas('T', -1., a, x, 1., y);
    for (int j = 0; j < a.columns / 6; ++j)
      {
        Vec6 sum = Vec6::Zero();
        for (int i = 0; i < a.rows / 6; ++i)
          sum.noalias() += a.block(i, j).transpose() * Eigen::Map<const Vec6>(x + 6 * i);
        Eigen::Map<Vec6>(y + 6 * j) -= sum;
      }
  }



  void set_product(const DenseView &a, const double *x, double *y)
  {
    if (is_for_blas(a))
      return call_blas('N', 1., a, x, 0., y);
    std::fill_n(y, a.rows, 0.);
    for (int j = 0; j < a.columns / 6; ++j)
      {
        const Vec6 part = Eigen::Map<const Vec6>(x + 6 * j);
        for (int i = 0; i < a.rows / 6; ++i)
          Eigen::Map<Vec6>(y + 6 * i).noalias() += a.block(i, j) * part;
      }
  }



  void divide(const DenseView &a, const DenseDivisor &d, const DenseView &x)
  {
    if (d.is_inverse())
      return multiply(1., a, d.matrix, 0., x);
    copy_matrix(a, x);
#pragma omp parallel for schedule(dynamic) if (2. * x.rows * x.columns * x.columns >= large_product)
    for (int i = 0; i < x.rows; i += rows_of_thread)
      divide_by_factors(x.part(i, 0, std::min(rows_of_thread, x.rows - i), x.columns), d);
  }



  void divide(const double *b, const DenseDivisor &d, double *x)
  {
    if (d.is_inverse())
      return set_product(d.matrix, b, x);
    constexpr int one  = 1;
    int           info = 0;
    const int     n    = d.matrix.rows;
    std::copy_n(b, n, x);
    dgetrs_("N", &n, &one, d.matrix.data, &d.matrix.stride, d.pivots, x, &n, &info);
  }



  void DenseInverse::reserve(const int n)
  {
    const auto size = static_cast<std::size_t>(n);
    copy.resize(std::max(copy.size(), size * size));
    work.resize(std::max(work.size(), size * size / 2));
  }



  bool DenseInverse::invert(const DenseDivisor &d, const double *largest)
  {
    const DenseView &a = d.matrix, kept = {copy.data(), a.rows, a.rows, a.rows};
    copy_matrix(a, kept);
    d.pivots[0] = 0;
    if (invert_halves(a, largest, work.data()) &&
        condition(matrix(a), matrix(kept)) <= a.rows * worst_condition_of_inverse)
      return true;
    copy_matrix(kept, a);
    for (int k = 0; k < a.rows / 6; ++k)
      if (!(a.block(k, k).cwiseAbs().maxCoeff() <= largest[k]))
        return false;
    int info = 0;
    dgetrf_(&a.rows, &a.rows, a.data, &a.stride, d.pivots, &info);
    return info == 0 && is_finite(a);
  }
} // namespace hybrid::dda
