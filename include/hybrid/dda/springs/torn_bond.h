// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs/springs.h>

namespace hybrid::dda
{
  /// Of a bond that is torn in a step: what is taken from its traction at the end, in Newmark's
  /// weight gamma, and its derivatives.
  struct TakenBack
  {
    Springs::Traction traction{0., 0.}; ///< [Pa]
    double            by_gap  = 0.;     ///< [Pa/m]
    double            by_slip = 0.;     ///< likewise of the shear
  };


  /**
   * A bond that was pressed when the step began, or sheared, and is torn in it: with the weight 1 -
   * gamma its traction F0 goes on pushing over the whole way u, however far it opens. Where steps
   * do not resolve the bond's own vibration this gives more than the bond has stored, W. What is
   * beyond is taken back, so that the bond gives (1 - gamma) F0 u or W, whichever is less:
   *
   *     gamma T = (1 - gamma) F0 - W / u      if (1 - gamma) F0 u > W
   *
   * continuous in u, and none of it where a step is short beside the vibration. Only the part that
   * is torn in this step counts.
   * @param now state at the end of the trial  @param gamma Newmark's [-]
   */
  TakenBack taken_back(const Springs::Spring &spring, const SpringState &now, double gamma);
} // namespace hybrid::dda
