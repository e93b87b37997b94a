// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/substitution_plan.h>

#include <Eigen/Core>

#include <numeric>
#include <vector>

namespace hybrid::continuum
{
  /// A factor of supernodes of given widths, whose rows below are chosen: the last unknowns are the
  /// surface's, without columns. Unknowns before they were ordered stand the other way round.
  struct DenseSupernodes
  {
    std::vector<int>    first_column = {0}, row_begin = {0}, row, value_begin, permutation;
    std::vector<double> values;
    int                 n_interior = 0, n_surface = 0;

    /// @param below rows of each supernode below its own, ascending
    DenseSupernodes(const std::vector<int>              &widths,
                    const std::vector<std::vector<int>> &below,
                    const int                            surface)
      : n_interior(std::accumulate(widths.begin(), widths.end(), 0))
      , n_surface(surface)
    {
      for (std::size_t k = 0; k < widths.size(); ++k)
        {
          const int first = first_column.back();
          for (int i = 0; i < widths[k]; ++i)
            row.push_back(first + i);
          row.insert(row.end(), below[k].begin(), below[k].end());
          const int n_rows = static_cast<int>(row.size()) - row_begin.back();
          value_begin.push_back(static_cast<int>(values.size()));
          for (int j = 0; j < widths[k]; ++j)
            for (int i = 0; i < n_rows; ++i)
              values.push_back(i < j ? 1e9 : (i == j ? 2. : 0.1) + 0.01 * ((7 * i + 3 * j) % 11));
          row_begin.push_back(static_cast<int>(row.size()));
          first_column.push_back(first + widths[k]);
        }
      for (int i = 0; i < n_interior + n_surface; ++i)
        permutation.push_back(i < n_interior ? n_interior - 1 - i : i);
    }

    SupernodalPattern pattern() const
    {
      return {n_interior,
              n_surface,
              static_cast<int>(value_begin.size()),
              first_column.data(),
              row_begin.data(),
              row.data(),
              value_begin.data(),
              permutation.data()};
    }

    /// [L_II; L_GI].
    Eigen::MatrixXd matrix() const
    {
      Eigen::MatrixXd l = Eigen::MatrixXd::Zero(n_interior + n_surface, n_interior);
      for (std::size_t k = 0; k < value_begin.size(); ++k)
        {
          const int n_rows = row_begin[k + 1] - row_begin[k];
          for (int j = 0; j < first_column[k + 1] - first_column[k]; ++j)
            for (int i = j; i < n_rows; ++i)
              l(row[row_begin[k] + i], first_column[k] + j) =
                values[value_begin[k] + j * n_rows + i];
        }
      return l;
    }
  };



  /// Forty leaves of three to five columns under two supernodes of twelve and twenty, four unknowns
  /// of the surface.
  inline DenseSupernodes two_level_supernodes()
  {
    std::vector<int>              widths;
    std::vector<std::vector<int>> below;
    int                           leaves = 0;
    for (int k = 0; k < 40; ++k)
      {
        widths.push_back(3 + k % 3);
        leaves += widths.back();
      }
    const int first = leaves, second = first + 12, surface = second + 20;
    for (int k = 0; k < 40; ++k)
      below.push_back(
        {first + k % 12, second + k % 7, second + 7 + k % 5, second + 19, surface + k % 4});
    widths.insert(widths.end(), {12, 20});
    below.push_back({second, second + 1, second + 3, surface + 1});
    below.push_back({surface, surface + 1, surface + 2, surface + 3});
    return {widths, below, 4};
  }
} // namespace hybrid::continuum
