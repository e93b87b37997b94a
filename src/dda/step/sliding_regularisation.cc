// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/sliding_regularisation.h>

#include <algorithm>

namespace hybrid::dda
{
  bool SlidingRegularisation::adapt(const double fraction)
  {
    const double     before    = share;
    constexpr double min_share = 1e-3, max_share = 1., factor = 8.;
    if (fraction < 0.25)
      share = std::min(max_share, std::max(min_share, factor * share));
    else if (fraction > 0.7)
      share = share / factor < min_share ? 0. : share / factor;
    return share != before;
  }
} // namespace hybrid::dda
