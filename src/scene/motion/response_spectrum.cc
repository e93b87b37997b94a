// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/response_spectrum.h>
#include <hybrid/scene/text_table.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// One step of an oscillator under a(t) linear over the step: x_1 = A x_0 + B (a_0, a_1).
    class OscillatorStep
    {
    public:
      OscillatorStep(const double w, const double z, const double dt)
      {
        // Particular solution of u'' + 2 z w u' + w^2 u = -(a_0 + s t), s = (a_1 - a_0)/dt:
        // u_p = -(a_0 + s t)/w^2 + 2 z s/w^3; the rest is a free vibration.
        const double wd = w * std::sqrt(1. - z * z), e = std::exp(-z * w * dt);
        const double c = std::cos(wd * dt), s = std::sin(wd * dt) / wd;
        uu                 = e * (c + z * w * s);
        uv                 = e * s;
        vu                 = -w * w * uv;
        vv                 = e * (c - z * w * s);
        const double slope = 2. * z / (w * w * w), w2 = 1. / (w * w);
        for (int k = 0; k < 2; ++k)
          {
            const double a0 = k == 0 ? 1. : 0., a1 = 1. - a0, rate = (a1 - a0) / dt;
            const double u0 = a0 * w2 - slope * rate, v0 = rate * w2; // free part for rest at 0
            ua[k] = uu * u0 + uv * v0 - a1 * w2 + slope * rate;
            va[k] = vu * u0 + vv * v0 - rate * w2;
          }
      }

      void advance(double &u, double &v, const double a0, const double a1) const
      {
        const double next = uu * u + uv * v + ua[0] * a0 + ua[1] * a1;
        v                 = vu * u + vv * v + va[0] * a0 + va[1] * a1;
        u                 = next;
      }

    private:
      double uu, uv, vu, vv, ua[2], va[2];
    };
  } // namespace


  double spectral_acceleration(const Motion &motion, const double f, const double damping)
  {
    assert(f > 0. && damping >= 0. && damping < 1.);
    const std::vector<double> &a = motion.samples();
    if (a.size() < 2)
      return 0.;
    const int    parts = std::max(1, static_cast<int>(std::ceil(60. * f * motion.time_step())));
    const double dt = motion.time_step() / parts, w = 2. * M_PI * f;

    const OscillatorStep step(w, damping, dt);
    double               u = 0., v = 0., largest = 0.;
    for (std::size_t i = 1; i < a.size(); ++i)
      for (int p = 0; p < parts; ++p)
        {
          const double slope = (a[i] - a[i - 1]) / parts;
          step.advance(u, v, a[i - 1] + p * slope, a[i - 1] + (p + 1) * slope);
          largest = std::max(largest, std::abs(u));
        }
    for (double t = 0.; t < 1. / f; t += dt)
      {
        step.advance(u, v, 0., 0.);
        largest = std::max(largest, std::abs(u));
      }
    return w * w * largest;
  }


  ResponseSpectrum::ResponseSpectrum(std::vector<double> frequencies,
                                     std::vector<double> accelerations)
    : f(std::move(frequencies))
    , a(std::move(accelerations))
  {
    assert(f.size() == a.size() && f.size() > 1);
  }


  double ResponseSpectrum::at(const double frequency) const
  {
    if (frequency <= f.front())
      return a.front();
    if (frequency >= f.back())
      return a.back();
    const std::size_t i        = std::upper_bound(f.begin(), f.end(), frequency) - f.begin();
    const double      fraction = std::log(frequency / f[i - 1]) / std::log(f[i] / f[i - 1]);
    return a[i - 1] * std::pow(a[i] / a[i - 1], fraction);
  }


  ResponseSpectrum
  read_response_spectrum(const std::string &file, const bool by_frequency, const double unit)
  {
    const std::string   what = by_frequency ? "a frequency [Hz]" : "a period [s]";
    std::vector<double> frequencies, accelerations;
    for (const TableRow &row : read_text_table(file))
      {
        if (row.fields.size() != 2)
          throw wrong_columns(row, what + " and a spectral acceleration", file);
        const double x = to_number(row.fields[0], what, file, row.line);
        const double y = to_number(row.fields[1], "a spectral acceleration", file, row.line);
        if (x == 0. && !by_frequency)
          continue;
        if (!(x > 0.) || !(y > 0.))
          throw InputError(file,
                           row.line,
                           "'" + row.fields[0] + ", " + row.fields[1] + "' must be " + what +
                             " and a spectral acceleration, both above zero.");
        const double f = by_frequency ? x : 1. / x;
        if (!frequencies.empty() && f == frequencies.back())
          throw InputError(file,
                           row.line,
                           row.fields[0] + " stands in the row before too; " + what +
                             " may have one value only.");
        frequencies.push_back(f);
        accelerations.push_back(unit * y);
        const std::size_t n = frequencies.size();
        if (n > 2 &&
            (frequencies[n - 1] > frequencies[n - 2]) != (frequencies[n - 2] > frequencies[n - 3]))
          throw InputError(file,
                           row.line,
                           row.fields[0] + " is out of order; " + what +
                             " must rise or fall from row to row.");
      }
    if (frequencies.size() < 2)
      throw InputError(
        file, 0, "a spectrum needs at least two rows of " + what + " and spectral acceleration.");
    if (frequencies.front() > frequencies.back())
      {
        std::reverse(frequencies.begin(), frequencies.end());
        std::reverse(accelerations.begin(), accelerations.end());
      }
    return {frequencies, accelerations};
  }
} // namespace hybrid::scene
