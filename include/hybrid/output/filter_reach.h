// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::output
{
  /**
   * How far from its ends a filtered history is not to be compared [s].
   *
   * A zero-phase filter looks both ways, and at the ends there is nothing to look at:
   * scene::low_pass() continues the record by point reflection about its last value, which so
   * passes with all that single steps have above the corner. What lies the time t beyond counts as
   * exp(-sqrt(2) pi corner t), the decay of a Butterworth filter of second order: 1.2 % after one
   * period of the corner, which is what is left out.
   *
   * @param corner of the filter [Hz]; 0: there is none, and nothing is left out
   * @param length of the record [s], a quarter of which is left out at most
   */
  double filter_reach(double corner, double length);
} // namespace hybrid::output
