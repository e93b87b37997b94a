// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <vector>

namespace hybrid::test
{
  /// Lower triangle by columns of a matrix on a grid of two unknowns per node, each coupled to the
  /// neighbours of its node, the corner's included.
  struct GridMatrix
  {
    int                 size;
    std::vector<int>    start = {0}, row;
    std::vector<double> values;

    GridMatrix(const int nx, const int ny)
      : size(2 * nx * ny)
    {
      for (int node = 0; node < nx * ny; ++node)
        for (int c = 0; c < 2; ++c)
          {
            for (const std::array<int, 2> by :
                 {std::array<int, 2>{0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}})
              {
                const int i = node % nx + by[0], j = node / nx + by[1];
                if (i < 0 || i >= nx || j >= ny)
                  continue;
                for (int d = 0; d < 2; ++d)
                  if (const int other = 2 * (j * nx + i) + d; other >= 2 * node + c)
                    {
                      row.push_back(other);
                      values.push_back(other == 2 * node + c ? 20. : std::sin(row.size() + 1.));
                    }
              }
            start.push_back(static_cast<int>(row.size()));
          }
    }

    Eigen::MatrixXd dense() const
    {
      Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
      for (int j = 0; j < size; ++j)
        for (int e = start[j]; e < start[j + 1]; ++e)
          a(row[e], j) = a(j, row[e]) = values[e];
      return a;
    }
  };
} // namespace hybrid::test
