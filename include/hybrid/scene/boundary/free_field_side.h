// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/boundary/side_boundary.h>

namespace hybrid::scene
{
  /// Dashpots and tractions relative to a 1D column solved beside the model.
  inline SideBoundary free_field_side()
  {
    SideBoundary side{"free field", "free field"};
    side.normal_dashpots = side.shear_dashpots = 1.;
    side.has_free_field                        = true;
    return side;
  }
} // namespace hybrid::scene
