// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/motion_measures.h>
#include <hybrid/scene/motion/motion_words.h>
#include <hybrid/scene/motion/response_spectrum.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// From 5 to 95 % of the integral of a^2 [s].
    double husid_duration(const Motion &motion)
    {
      double whole = 0., sum = 0., first = -1.;
      for (const double a : motion.samples())
        whole += a * a;
      for (std::size_t i = 0; i < motion.samples().size(); ++i)
        {
          sum += motion.samples()[i] * motion.samples()[i];
          if (first < 0. && sum >= 0.05 * whole)
            first = i * motion.time_step();
          if (sum >= 0.95 * whole)
            return i * motion.time_step() - first;
        }
      return 0.;
    }
  } // namespace


  MotionMeasures measure(const Motion &motion)
  {
    MotionMeasures result;
    result.peak_acceleration = motion.peak_acceleration();
    if (result.peak_acceleration == 0.)
      return result;
    result.peak_velocity        = largest_velocity(motion);
    result.significant_duration = husid_duration(motion);
    const auto look_at          = [&](const double period) {
      const double acceleration = spectral_acceleration(motion, 1. / period, 0.05);
      if (acceleration > result.spectral_peak)
        {
          result.spectral_peak   = acceleration;
          result.spectral_period = period;
        }
    };
    constexpr int periods = 60, finer = 10; // a tenth apart, then a hundredth about the largest
    for (int k = 0; k <= periods; ++k)
      look_at(0.02 * std::pow(500., double(k) / periods));
    const double middle = result.spectral_period;
    for (int k = -finer; k <= finer; ++k)
      look_at(middle * std::pow(500., double(k) / (periods * finer)));
    return result;
  }
} // namespace hybrid::scene
