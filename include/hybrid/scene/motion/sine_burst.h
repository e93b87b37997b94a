// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/motion/motion_source.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /**
   * Sine burst of n = parameters.cycles cycles of f = parameters.frequency:
   *   a(t) = w(t) sin(2 pi f t),  0 <= t <= n/f,
   * where w rises from 0 to 1 as sin^2 over the first parameters.taper cycles (NaN: two, at most
   * half of all) and falls likewise over the last ones (0: a plain burst). Baseline-corrected if
   * asked for: without, an integer number of cycles ends at rest but displaced. Largest |a| is
   * about 1 m/s2.
   *
   * @param time_step dt of the run [s]; the burst is sampled at an integer fraction of it.
   */
  Motion make_sine_burst(const MotionParameters &parameters, double time_step);


  /// The burst with a peak of 1 m/s2 as a source of motions.
  MotionSource sine_source();


  /// Sample spacing [s] of waves made from formulas: an integer fraction of @p time_step, at least
  /// 400 samples per period of @p frequency: the chords between them are 3e-5 of the peak off.
  double wave_spacing(double frequency, double time_step);
} // namespace hybrid::scene
