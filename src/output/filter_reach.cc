// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/filter_reach.h>

#include <algorithm>

namespace hybrid::output
{
  double filter_reach(const double corner, const double length)
  {
    constexpr double most = 0.25; ///< of the record, at each end
    return corner > 0. ? std::min(1. / corner, most * length) : 0.;
  }
} // namespace hybrid::output
