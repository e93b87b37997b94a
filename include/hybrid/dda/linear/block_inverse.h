// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace hybrid::dda
{
  /**
   * Inverse of a 6x6 block by Gauss-Jordan elimination with partial pivoting, all loops of fixed
   * length. Entries that are not finite where it is singular.
   */
  inline Mat6 pivoted_inverse(const Mat6 &block)
  {
    // Columns of the block are rows of its transpose, and lie together: the transpose is inverted.
    Mat6               a = block;
    std::array<int, 6> row;
    for (int k = 0; k < 6; ++k)
      {
        int pivot = k;
        for (int i = k + 1; i < 6; ++i)
          if (std::abs(a(k, i)) > std::abs(a(k, pivot)))
            pivot = i;
        row[k] = pivot;
        if (pivot != k)
          a.col(k).swap(a.col(pivot));
        const double inverse = 1. / a(k, k);
        a(k, k)              = 1.;
        a.col(k) *= inverse;
        for (int i = 0; i < 6; ++i)
          {
            if (i == k)
              continue;
            const double factor = a(k, i);
            a(k, i)             = 0.;
            a.col(i) -= factor * a.col(k);
          }
      }
    for (int k = 5; k >= 0; --k)
      if (row[k] != k)
        a.row(k).swap(a.row(row[k]));
    return a;
  }



  /**
   * Inverse of a 6x6 block: by halves, those of the motion of the centroid and of the strains,
   * which takes a third of the time; with pivots where the first half is nearly singular.
   */
  inline Mat6 block_inverse(const Mat6 &a)
  {
    constexpr double      worst_condition = 1e3;
    const auto            upper = a.topLeftCorner<3, 3>(), right = a.topRightCorner<3, 3>();
    const auto            left = a.bottomLeftCorner<3, 3>(), lower = a.bottomRightCorner<3, 3>();
    const Eigen::Matrix3d first = upper.inverse();
    if (!(first.cwiseAbs().maxCoeff() * upper.cwiseAbs().maxCoeff() <= worst_condition))
      return pivoted_inverse(a);
    const Eigen::Matrix3d first_right = first * right;
    const Eigen::Matrix3d second      = (lower - left * first_right).inverse();
    const Eigen::Matrix3d second_left = second * left * first;
    Mat6                  result;
    result.topLeftCorner<3, 3>()     = first + first_right * second_left;
    result.topRightCorner<3, 3>()    = -first_right * second;
    result.bottomLeftCorner<3, 3>()  = -second_left;
    result.bottomRightCorner<3, 3>() = second;
    return result;
  }



  /**
   * Condition of a matrix up to which its inverse takes the place of its triangular factors.
   *
   * What hardly holds to anything, such as a block between contacts that are open, has one of 1e11
   * in a static step. Products with the inverse then lose all digits, solutions with the factors
   * none that the matrix has (du Croz and Higham 1992, section 2).
   */
  constexpr double worst_condition_of_inverse = 1e6;



  /// Condition of a matrix: trace of |inverse| |matrix|, at least its size. It does not depend on
  /// units, of rows or columns (Skeel 1979). Not finite where the inverse is not.
  template <typename Inverse, typename Matrix>
  double condition(const Eigen::MatrixBase<Inverse> &inverse,
                   const Eigen::MatrixBase<Matrix>  &matrix)
  {
    return inverse.cwiseProduct(matrix.transpose()).cwiseAbs().rowwise().sum().sum();
  }
} // namespace hybrid::dda
