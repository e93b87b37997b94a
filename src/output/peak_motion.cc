// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/peak_motion.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>

namespace hybrid::output
{
  void PeakMotion::start(const double *velocity, const std::size_t n)
  {
    previous.assign(velocity, velocity + n);
    value.assign(n, 0.);
    rate.assign(n, 0.);
    for (std::vector<double> &peaks : largest)
      peaks.assign(n, 0.);
    for (std::size_t i = 0; i < n; ++i)
      largest[1][i] = std::abs(velocity[i]);
  }



  void PeakMotion::add(const double *displacement,
                       const double *velocity,
                       const double  dt,
                       const double *base)
  {
    constexpr double damping = 0.70710678118654752;
    const double     turn    = M_PI * corner * dt; // half the phase of a step
    const bool       is_raw  = corner == 0. || turn > 0.45 * M_PI;
    const double     w       = is_raw ? 0. : 2. / dt * std::tan(turn);
    const double     push = w * w, divisor = 1. / (2. + dt * w * (0.5 * dt * w + 2. * damping));
    const double     per_step = 1. / dt;
    for (std::size_t i = 0; i < previous.size(); ++i)
      {
        const double change = velocity[i] - previous[i];
        previous[i]         = velocity[i];
        if (is_raw)
          value[i] = change * per_step;
        else
          {
            const double mean = (2. * rate[i] + push * (change - dt * value[i])) * divisor;
            value[i] += dt * mean;
            rate[i] = 2. * mean - rate[i];
          }
        largest[0][i] = std::max(largest[0][i], std::abs(value[i]));
        largest[1][i] = std::max(largest[1][i], std::abs(velocity[i]));
        largest[2][i] = std::max(largest[2][i], std::abs(displacement[i] - base[i % 2]));
      }
  }



  void PeakMotion::serialize(restart::Archive &archive)
  {
    archive(value, rate, previous, largest[0], largest[1], largest[2]);
  }
} // namespace hybrid::output
