// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace hybrid::scene
{
  /**
   * Zero-phase low-pass of an equally spaced series: a second-order Butterworth filter
   * (bilinear transform, frequency prewarped) run forwards and then backwards. The gain is
   *   1 / (1 + w^4),  w = tan(pi f dt) / tan(pi corner dt),
   * so 1/2 at the corner; there is no delay. At both ends the series is continued by point
   * reflection (2 x_end - x) over three periods of the corner, or as far as it reaches, and the
   * filter starts in the steady state of the first value, so a straight line passes unchanged
   * to the accuracy of the reflection.
   *
   * @param dt spacing [s], > 0.  @param corner [Hz]; <= 0 or at least the Nyquist frequency
   * 1/(2 dt): the series is returned unchanged.
   */
  std::vector<double> low_pass(const std::vector<double> &series, double dt, double corner);
} // namespace hybrid::scene
