// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/boundary/base_boundary.h>

namespace hybrid::scene
{
  /// Displacement prescribed: the motion itself.
  inline BaseBoundary rigid_base()
  {
    BaseBoundary base{"rigid", "rigid base that moves with the motion"};
    base.takes_motion = true;
    return base;
  }
} // namespace hybrid::scene
