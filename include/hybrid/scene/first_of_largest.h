// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hybrid
{
  /// Number of the first of the largest @p values: round-off does not decide between equal ones.
  /// There is at least one value.
  inline std::size_t first_of_largest(const std::vector<double> &values)
  {
    constexpr double round_off = 1e-6; // of what solvers leave, over the largest
    const double     largest   = *std::max_element(values.begin(), values.end());
    const double     bound     = largest - round_off * std::abs(largest);
    return std::find_if(values.begin(),
                        values.end(),
                        [bound](const double value) { return value >= bound; }) -
           values.begin();
  }
} // namespace hybrid
