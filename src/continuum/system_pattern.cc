// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/system_pattern.h>

#include <algorithm>
#include <utility>

namespace hybrid::continuum
{
  std::vector<double> SystemPattern::values(const std::vector<double> &blocks) const
  {
    std::vector<double> result(source.size());
    for (std::size_t k = 0; k < source.size(); ++k)
      result[k] = source[k] >= 0 ? blocks[source[k]] : support_ratio * blocks[-1 - source[k]];
    return result;
  }


  SystemPattern make_system_pattern(const NodeMatrices      &matrices,
                                    const std::vector<int>  &system_of_dof,
                                    const std::vector<int>  &dof_of_system,
                                    const std::vector<char> &isolated)
  {
    SystemPattern                    pattern;
    std::vector<std::pair<int, int>> column; // row, source
    pattern.column_start = {0};
    for (std::size_t j = 0; j < dof_of_system.size(); ++j)
      {
        const int dof = dof_of_system[j], node = dof / 2;
        column.clear();
        for (int e = matrices.row_start[node]; e < matrices.row_start[node + 1]; ++e)
          for (int c = 0; c < 2; ++c)
            {
              const int other = 2 * matrices.column[e] + c;
              const int i     = system_of_dof[other];
              const int index = 4 * e + 2 * (dof % 2) + c;
              if (i < static_cast<int>(j))
                continue;
              if (!isolated[dof] && !isolated[other])
                column.emplace_back(i, index);
              else if (dof == other)
                column.emplace_back(i, -1 - index);
            }
        std::sort(column.begin(), column.end());
        for (const auto &[i, index] : column)
          {
            pattern.row.push_back(i);
            pattern.source.push_back(index);
          }
        pattern.column_start.push_back(static_cast<int>(pattern.row.size()));
      }
    return pattern;
  }
} // namespace hybrid::continuum
