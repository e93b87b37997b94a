// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion_source.h>

namespace hybrid::scene
{
  /// Two columns t [s], a [file_unit m/s2], equally spaced.
  MotionSource text_source();


  /// PEER AT2; in units of g unless the header names cm/s2 or m/s2.
  MotionSource at2_source();
} // namespace hybrid::scene
