// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace hybrid::dda
{
  /// A dense matrix by columns, in memory of others; rows and columns are multiples of 6.
  struct DenseView
  {
    double *data;
    int     rows, columns;
    int     stride; ///< from one column to the next

    double *at(const int row, const int column) const
    {
      return data + row + static_cast<std::ptrdiff_t>(column) * stride;
    }

    /// 6x6 block.
    Eigen::Map<Mat6, 0, Eigen::OuterStride<>> block(const int i, const int j) const
    {
      return Eigen::Map<Mat6, 0, Eigen::OuterStride<>>(at(6 * i, 6 * j),
                                                       Eigen::OuterStride<>(stride));
    }

    DenseView part(const int row, const int column, const int n_rows, const int n_columns) const
    {
      return {at(row, column), n_rows, n_columns, stride};
    }
  };


  /// C = beta C + alpha A B; threads share the columns of large products, with the same bits for
  /// any number of them.
  void
  multiply(double alpha, const DenseView &a, const DenseView &b, double beta, const DenseView &c);

  /// C = C - A B^T for a square C, of which the part above the diagonal is left without sense.
  void subtract_lower(const DenseView &a, const DenseView &b, const DenseView &c);

  /// y = y - A x
  void subtract_product(const DenseView &a, const double *x, double *y);

  /// y = y - A^T x
  void subtract_transposed_product(const DenseView &a, const double *x, double *y);

  /// y = A x
  void set_product(const DenseView &a, const double *x, double *y);


  /// What stands in the place of a matrix D to divide by it: D^-1, or where products with it would
  /// lose digits (worst_condition_of_inverse) the LU factors of D.
  struct DenseDivisor
  {
    DenseView matrix;
    int      *pivots; ///< rows exchanged in the factors, from 1; the first is 0 if it is D^-1

    bool is_inverse() const
    {
      return pivots[0] == 0;
    }
  };


  /// X = A D^-1; threads share the rows of large ones, with the same bits for any number of them.
  void divide(const DenseView &a, const DenseDivisor &d, const DenseView &x);

  /// x = D^-1 b
  void divide(const double *b, const DenseDivisor &d, double *x);


  /**
   * Inverse of the own blocks of a front, in place: by halves, down to 6x6 blocks, which is
   * products of matrices for the most part. Rows are exchanged within 6x6 blocks. Where entries
   * grow, or the inverse would lose digits, LU factors with rows exchanged among all (LAPACK).
   */
  class DenseInverse
  {
  public:
    /// Room for matrices of up to @p n rows.
    void reserve(int n);

    /// @param d holds D, then its inverse or factors
    /// @param largest entry that each 6x6 block of the diagonal may have when its turn comes
    /// @return false if the matrix is singular, or if the blocks are too large to begin with
    bool invert(const DenseDivisor &d, const double *largest);

  private:
    std::vector<double> copy, work;
  };
} // namespace hybrid::dda
