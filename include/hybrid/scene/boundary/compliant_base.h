// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/boundary/base_boundary.h>

namespace hybrid::scene
{
  /// Dashpots over a half space through which the motion arrives.
  inline BaseBoundary compliant_base()
  {
    BaseBoundary base{"compliant", "compliant base: the motion comes in, waves go out"};
    base.is_compliant = base.takes_motion = true;
    return base;
  }
} // namespace hybrid::scene
