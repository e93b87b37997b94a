// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/newmark.h>

#include <complex>

namespace hybrid::output
{
  /// What decides how late a step makes a wave.
  struct StepScheme
  {
    Newmark newmark;
    double  dt           = 0.; ///< [s]
    double  late_damping = 0.; ///< beta_K of what follows the mean rate of the step: blocks on the
                               ///< way, or explicit rock [s]
    double uncorrected = 0.;   ///< see Continuum::uncorrected_part() [-]
  };


  /**
   * The frequency s' = i w' that a model takes a motion of frequency s = i w for when it is
   * computed in steps, less s [1/s]. A linear model with the transfer function H(s) answers with
   * H(s'), as far as its waves are concerned.
   *
   * Newmark's pairs with 2 beta = gamma have, with x = tanh(s dt / 2) and e = exp(-s dt),
   *   s'^2 = (2 x / dt)^2 / (1 + 2 x (gamma - 1/2 - f (e / 2) / (1 - e / 2))),
   * f the filter: their transfer function from forces to motion, exactly. To second order
   * w' = w (1 + (1/12 + f) (w dt)^2) with a filter, and the imaginary part is the damping.
   *
   * Central differences (beta = 0) have s' = 2 / dt sinh(s dt / 2).
   *
   * - The damping of blocks, and of rock in explicit steps, follows the mean rate of the step,
   * which is that of half a step before: 1 + beta_K (1 - e) / dt in place of 1 + beta_K s. What
   * that makes softer or stiffer counts as frequency.
   * - The corrected inertia of the fourth order leaves (w dt)^4 / 480, and of its elements the
   *   uncorrected part of (w dt)^2 / 12.
   */
  std::complex<double> frequency_error(const StepScheme &scheme, std::complex<double> s);
} // namespace hybrid::output
