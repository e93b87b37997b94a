// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/motion/motion_source.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /// Amplitude over time s = t/T in [0, 1] [-]: s^2 up to 15 %, 1 until 60 %, cos^2 to zero at 1.
  double earthquake_envelope(double s);


  /**
   * Artificial accelerogram: band-limited Gaussian noise with the Kanai-Tajimi spectrum
   *   S(f) ~ (1 + 4 z^2 r^2) / ((1 - r^2)^2 + 4 z^2 r^2),  r = f / frequency, z = 0.6
   * (Kanai 1957, Tajimi 1960), with clough_penzien times the second filter
   *   q^4 / ((1 - q^2)^2 + 4 z^2 q^2),  q = 10 r
   * (Clough & Penzien 1975), from lowest_frequency to highest_frequency as a sum of
   * harmonics with normally distributed amplitudes, times an envelope that rises as t^2 over
   * the first 15 % of the duration, is 1 until 60 %, and falls as cos^2 to zero at the end.
   *
   * The normal deviates come from std::mt19937_64 (seed) by Box and Muller's method, so the
   * same seed gives the same motion with every standard library, whatever the time step of
   * the run (50 samples per shortest period). With baseline_correction (baseline.h) the
   * motion ends at rest where it began. The largest |a| is 1 m/s2.
   */
  Motion make_synthetic_motion(const MotionParameters &parameters);


  /// @throws InputError of @p table if the lowest frequency is not below the highest.
  void check_frequency_band(const MotionParameters &motion, const ParameterTable &table);


  /// It as a source of motions.
  MotionSource synthetic_source();
} // namespace hybrid::scene
