// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace hybrid::dda
{
  /**
   * The dynamic stiffness S of a moving foundation as the blocks see it, symmetric positive
   * definite [N/m per m]: all entries of a matrix, or those of a band. It refers to the numbers of
   * another, which must outlive it.
   */
  class FoundationStiffness
  {
  public:
    /// None: there is no moving foundation.
    FoundationStiffness() = default;

    /// All entries of a matrix; nullptr: none.
    FoundationStiffness(const Eigen::MatrixXd *matrix)
    {
      if (matrix == nullptr)
        return;
      first     = matrix->data();
      n         = static_cast<int>(matrix->rows());
      last      = std::max(0, n - 1);
      to_column = n + 1;
    }

    /// Entries at most rows() - 1 from the diagonal. @param rows r: S(j + r, j) in column j
    static FoundationStiffness band(const Eigen::MatrixXd &rows)
    {
      FoundationStiffness s;
      s.first     = rows.data();
      s.n         = static_cast<int>(rows.cols());
      s.last      = static_cast<int>(rows.rows()) - 1;
      s.to_column = rows.rows();
      return s;
    }

    bool exists() const
    {
      return first != nullptr;
    }

    int size() const
    {
      return n;
    }

    /// Entries farther from the diagonal are zero.
    int reach() const
    {
      return last;
    }

    /// S(j, j); those below it in its column follow.
    const double *column(const int j) const
    {
      return first + j * to_column;
    }

    double operator()(const int i, const int j) const
    {
      const int below = std::abs(i - j);
      return below <= last ? column(std::min(i, j))[below] : 0.;
    }

    /// All entries.
    Eigen::MatrixXd dense() const
    {
      return Eigen::MatrixXd::NullaryExpr(n, n, [this](const Eigen::Index i, const Eigen::Index j) {
        return (*this)(static_cast<int>(i), static_cast<int>(j));
      });
    }

    /// Whether both refer to the same numbers.
    bool operator==(const FoundationStiffness &other) const
    {
      return first == other.first && n == other.n && last == other.last;
    }

  private:
    const double  *first = nullptr;
    int            n = 0, last = 0;
    std::ptrdiff_t to_column = 0; ///< numbers from one diagonal entry to the next
  };
} // namespace hybrid::dda
