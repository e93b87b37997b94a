// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/boundary/side_boundary.h>

namespace hybrid::scene
{
  /// Horizontal displacement zero.
  inline SideBoundary roller_side()
  {
    SideBoundary side{"roller", "rollers"};
    side.holds_x = true;
    return side;
  }
} // namespace hybrid::scene
