// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/motion_parameters.h>

namespace hybrid::scene
{
  /// log10 M_0 = 1.5 M + 9.05 [N m] (Hanks & Kanamori 1979).
  double seismic_moment(const EarthquakeSource &source);

  /// f_c = 0.49 b (d sigma / M_0)^(1/3) [Hz] (Brune 1970).
  double corner_frequency(const EarthquakeSource &source);

  /// Of strong shaking [s]: 1/f_c at the source and 0.05 s per km on the way (Boore 2003, equation
  /// 7 and table 1).
  double shaking_duration(const EarthquakeSource &source);

  /**
   * Fourier amplitude of the acceleration [m/s] at @p f [Hz] (Boore 2003, equations 1 to 5):
   *   F 0.55 / sqrt(2) M_0 / (4 pi rho b^3 R) (2 pi f)^2 / (1 + (f/f_c)^2)
   *     exp(-pi f R / (Q b)) exp(-pi kappa f)
   * with the mean radiation of S waves (0.55), of which one horizontal component takes 1/sqrt(2).
   * @param free_surface F: 2 for the motion of an outcrop, 1 for the upgoing wave.
   */
  double fourier_amplitude(const EarthquakeSource &source, double f, double free_surface);
} // namespace hybrid::scene
