// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/motion.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hybrid::scene
{
  Motion::Motion(const double spacing, std::vector<double> acceleration_samples)
    : dt(spacing)
    , a(std::move(acceleration_samples))
    , v(a.size(), 0.)
    , u(a.size(), 0.)
  {
    assert(dt > 0.);
    for (std::size_t i = 1; i < a.size(); ++i)
      {
        v[i] = v[i - 1] + 0.5 * dt * (a[i - 1] + a[i]);
        u[i] = u[i - 1] + dt * v[i - 1] + dt * dt * (2. * a[i - 1] + a[i]) / 6.;
      }
  }


  Motion::Interval Motion::interval(const double t) const
  {
    const std::size_t last = a.size() - 1;
    const std::size_t i    = std::min(static_cast<std::size_t>(t / dt), last - 1);
    return {i, t - i * dt};
  }


  double Motion::acceleration(const double t) const
  {
    if (a.empty() || !(t >= 0. && t <= duration()))
      return 0.;
    if (a.size() == 1)
      return a[0];
    const auto [i, s] = interval(t);
    return a[i] + (a[i + 1] - a[i]) * (s / dt);
  }


  double Motion::velocity(const double t) const
  {
    if (a.empty() || !(t > 0.))
      return 0.;
    if (t >= duration())
      return v.back();
    const auto [i, s] = interval(t);
    return v[i] + s * (a[i] + (a[i + 1] - a[i]) * (0.5 * s / dt));
  }


  double Motion::displacement(const double t) const
  {
    if (a.empty() || !(t > 0.))
      return 0.;
    if (t >= duration())
      return u.back() + v.back() * (t - duration());
    const auto [i, s] = interval(t);
    return u[i] + s * (v[i] + s * (0.5 * a[i] + (a[i + 1] - a[i]) * (s / (6. * dt))));
  }


  double Motion::duration() const
  {
    return a.size() > 1 ? dt * (a.size() - 1) : 0.;
  }


  double Motion::peak_acceleration() const
  {
    double peak = 0.;
    for (const double value : a)
      peak = std::max(peak, std::abs(value));
    return peak;
  }


  Motion Motion::scaled(const double factor) const
  {
    Motion result = *this;
    for (std::vector<double> *series : {&result.a, &result.v, &result.u})
      for (double &value : *series)
        value *= factor;
    return result;
  }
} // namespace hybrid::scene
