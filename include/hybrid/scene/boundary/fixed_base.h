// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/boundary/base_boundary.h>

namespace hybrid::scene
{
  /// Displacement zero.
  inline BaseBoundary fixed_base()
  {
    return {"fixed", "fixed base"};
  }
} // namespace hybrid::scene
