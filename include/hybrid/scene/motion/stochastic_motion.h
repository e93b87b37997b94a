// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/motion/motion_source.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /// Amplitude of the noise over time t / t_n [-]: 1 at 0.2, 0.05 at 1 (Saragoni & Hart 1974 in the
  /// form of Boore 2003, equations 21 to 24).
  double saragoni_hart_window(double s);


  /**
   * Accelerogram of an earthquake by the stochastic method (Boore 2003): Gaussian noise (seed),
   * times saragoni_hart_window() with t_n = 2 shaking_duration(); its spectrum, scaled to 1 in the
   * root of the mean square, times fourier_amplitude(); transformed back.
   *
   * Amplitudes are cut below lowest_frequency and above highest_frequency, by cosine tapers over a
   * quarter of an octave inside. In front of the noise and behind it the motion lasts for one
   * period of the lowest frequency more. An outcrop's motion, or the upgoing wave if that is what
   * the motion means.
   */
  Motion make_stochastic_motion(const MotionParameters &parameters);


  /// Part of the source's Arias intensity that lies outside the band of the motion [-].
  double intensity_outside(const MotionParameters &parameters);


  /// It as a source of motions.
  MotionSource stochastic_source();
} // namespace hybrid::scene
