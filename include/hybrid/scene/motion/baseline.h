// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>

namespace hybrid::scene
{
  /**
   * The motion without drift: its velocity and displacement end at zero (to round-off of
   * Motion's own integrals).
   *
   * First the velocity's least-squares polynomial b1 t + b2 t^2 + b3 t^3 is taken out, i.e.
   * b1 + 2 b2 t + 3 b3 t^2 from the acceleration: this removes an offset and the slow drift
   * of an instrument. What is left at the end is removed by two smooth bumps over the whole
   * duration T, sin^2(pi t/T) and sin^2(pi t/T) cos(pi t/T), which vanish at both ends.
   * @p keep_shape leaves out the first part (for motions without an offset).
   *
   * A motion of fewer than four samples is returned as it is.
   */
  Motion baseline_corrected(const Motion &motion, bool keep_shape = false);
} // namespace hybrid::scene
