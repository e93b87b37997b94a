// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/earthquake_source.h>

#include <cmath>

namespace hybrid::scene
{
  double seismic_moment(const EarthquakeSource &source)
  {
    return std::pow(10., 1.5 * source.magnitude + 9.05);
  }


  double corner_frequency(const EarthquakeSource &source)
  {
    return 0.49 * source.velocity * std::cbrt(source.stress_drop / seismic_moment(source));
  }


  double shaking_duration(const EarthquakeSource &source)
  {
    const double per_length = 0.05e-3; // on the way [s/m]
    return 1. / corner_frequency(source) + per_length * source.distance;
  }


  double
  fourier_amplitude(const EarthquakeSource &source, const double f, const double free_surface)
  {
    const double radiation = 0.55, component = std::sqrt(0.5);
    const double b = source.velocity, R = source.distance;
    const double level = free_surface * radiation * component * seismic_moment(source) /
                         (4. * M_PI * source.density * b * b * b * R);
    const double w = 2. * M_PI * f, r = f / corner_frequency(source);
    const double Q = source.quality * std::pow(f, source.quality_exponent);
    return level * w * w / (1. + r * r) * std::exp(-M_PI * f * (R / (Q * b) + source.kappa));
  }
} // namespace hybrid::scene
