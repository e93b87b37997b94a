// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/boundary/side_boundary.h>

namespace hybrid::scene
{
  /// Dashpots of Lysmer and Kuhlemeyer (1969).
  inline SideBoundary viscous_side()
  {
    SideBoundary side{"viscous", "viscous"};
    side.normal_dashpots = side.shear_dashpots = 1.;
    return side;
  }
} // namespace hybrid::scene
