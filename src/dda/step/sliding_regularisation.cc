// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/sliding_regularisation.h>

#include <algorithm>

namespace hybrid::dda
{
  bool SlidingRegularisation::adapt(const double part)
  {
    const double     before = share;
    constexpr double least = 1e-3, most = 1., factor = 8.;
    if (part < 0.25)
      share = std::min(most, std::max(least, factor * share));
    else if (part > 0.7)
      share = share / factor < least ? 0. : share / factor;
    return share != before;
  }
} // namespace hybrid::dda
