// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/front_tree.h>

#include <algorithm>
#include <vector>

namespace hybrid::test
{
  /// Fronts of a rectangle of blocks, each coupled to those beside, above and below it.
  inline dda::FrontTree grid_fronts(const int columns, const int rows)
  {
    std::vector<dda::BlockMatrix::Pair> pairs;
    for (int b = 0; b < columns * rows; ++b)
      {
        if ((b + 1) % columns != 0)
          pairs.push_back({b, b + 1});
        if (b + columns < columns * rows)
          pairs.push_back({b, b + columns});
      }
    std::sort(pairs.begin(), pairs.end());
    return dda::FrontTree(columns * rows, pairs);
  }
} // namespace hybrid::test
