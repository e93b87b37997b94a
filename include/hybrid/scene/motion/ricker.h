// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion_source.h>

namespace hybrid::scene
{
  /// a(t) = A (1 - 2 s^2) exp(-s^2), s = pi f (t - t0), t0 = 1.5/f: starts and ends below 1e-7 A.
  /// Its velocity is A (t - t0) exp(-s^2), its displacement -A exp(-s^2) / (2 pi^2 f^2).
  MotionSource ricker_source();
} // namespace hybrid::scene
