// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/boundary/side_boundary.h>

namespace hybrid::scene
{
  /// Displacement zero.
  inline SideBoundary fixed_side()
  {
    SideBoundary side{"fixed", "fixed"};
    side.holds_x = side.holds_y = true;
    return side;
  }
} // namespace hybrid::scene
