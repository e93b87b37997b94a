// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/filter.h>

#include <algorithm>
#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// Second-order low-pass section, y = b0 x + b1 x' + b2 x'' - a1 y' - a2 y''.
    struct Butterworth
    {
      double b0, b1, b2, a1, a2;

      Butterworth(const double dt, const double corner)
      {
        const double k    = std::tan(M_PI * corner * dt);
        const double norm = 1. / (1. + std::sqrt(2.) * k + k * k);
        b0                = k * k * norm;
        b1                = 2. * b0;
        b2                = b0;
        a1                = 2. * (k * k - 1.) * norm;
        a2                = (1. - std::sqrt(2.) * k + k * k) * norm;
      }

      /// Filter in place, as if the first value had lasted for ever before.
      void run(std::vector<double> &x) const
      {
        double x1 = x.front(), x2 = x1, y1 = x1, y2 = x1;
        for (double &value : x)
          {
            const double y = b0 * value + b1 * x1 + b2 * x2 - a1 * y1 - a2 * y2;
            x2             = x1;
            x1             = value;
            y2             = y1;
            y1             = y;
            value          = y;
          }
      }
    };
  } // namespace


  std::vector<double>
  low_pass(const std::vector<double> &series, const double dt, const double corner)
  {
    const std::size_t n = series.size();
    if (n < 2 || corner <= 0. || corner * dt >= 0.5)
      return series;

    const std::size_t   pad = std::min<std::size_t>(n - 1, std::ceil(3. / (corner * dt)));
    std::vector<double> x(n + 2 * pad);
    for (std::size_t i = 0; i < pad; ++i)
      {
        x[i]           = 2. * series.front() - series[pad - i];
        x[pad + n + i] = 2. * series.back() - series[n - 2 - i];
      }
    std::copy(series.begin(), series.end(), x.begin() + pad);

    const Butterworth filter(dt, corner);
    for (int pass = 0; pass < 2; ++pass) // forwards, then backwards: the phases cancel
      {
        filter.run(x);
        std::reverse(x.begin(), x.end());
      }
    return std::vector<double>(x.begin() + pad, x.begin() + pad + n);
  }
} // namespace hybrid::scene
