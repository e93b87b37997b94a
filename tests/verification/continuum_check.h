// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace hybrid::test
{
  constexpr double pi = 3.14159265358979323846;


  /// Ricker wavelet as acceleration, peak 1 m/s2, centred 1.5 / f after its start.
  inline scene::Motion ricker(const double frequency, const double dt)
  {
    std::vector<double> a;
    for (int i = 0; i * dt <= 3. / frequency; ++i)
      {
        const double s = std::pow(pi * frequency * (i * dt - 1.5 / frequency), 2);
        a.push_back((1. - 2. * s) * std::exp(-s));
      }
    return {dt, a};
  }


  /// Fourier integral of samples at the ends of equal steps, first sample at dt.
  inline std::complex<double>
  fourier(const std::vector<double> &samples, const double dt, const double frequency)
  {
    std::complex<double> sum = 0.;
    for (std::size_t i = 0; i < samples.size(); ++i)
      sum += samples[i] * std::exp(std::complex<double>(0., -2. * pi * frequency * (i + 1) * dt));
    return sum * dt;
  }


  inline double largest(const std::vector<double> &samples)
  {
    double result = 0.;
    for (const double x : samples)
      result = std::max(result, std::abs(x));
    return result;
  }
} // namespace hybrid::test
