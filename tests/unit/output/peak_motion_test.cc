// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/peak_motion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using hybrid::output::PeakMotion;

  constexpr double corner = 25.;

  /// Peak acceleration of a sine in x that rises slowly to amplitude 1, with steps dt or (every
  /// other pair) two of half of it.
  double peak_of_sine(const double frequency, const double dt, const bool halves)
  {
    const double w = 2. * M_PI * frequency;
    PeakMotion   peaks(corner);
    double       v[2] = {0., 0.}, t = 0.;
    peaks.start(v, 2);
    const double base[2] = {0., 0.};
    for (int step = 0; t < 60. / frequency; ++step)
      for (int part = 0; part < (halves && step % 2 == 0 ? 2 : 1); ++part)
        {
          const double now = halves && step % 2 == 0 ? 0.5 * dt : dt;
          t += now;
          const double rise = std::min(1., t * frequency / 40.);
          v[0]              = -rise * std::cos(w * t) / w;
          const double u[2] = {-rise * std::sin(w * t) / (w * w), 0.};
          peaks.add(u, v, now, base);
        }
    EXPECT_NEAR(peaks.peak_velocity()[0], 1. / w, 1e-3 / w);
    EXPECT_NEAR(peaks.peak_displacement()[0], 1. / (w * w), 2e-3 / (w * w));
    EXPECT_EQ(peaks.peak_acceleration()[1], 0.);
    return peaks.peak_acceleration()[0];
  }
} // namespace



// |H| = 1 / sqrt(1 + (f / fc)^4) of a second-order Butterworth low-pass.
TEST(PeakMotion, accelerations_pass_a_butterworth_filter)
{
  EXPECT_NEAR(peak_of_sine(2.5, 1e-3, false), 1., 5e-3);
  EXPECT_NEAR(peak_of_sine(100., 1e-4, false), 1. / std::sqrt(257.), 0.03 / std::sqrt(257.));
  EXPECT_NEAR(peak_of_sine(25., 2e-4, false), std::sqrt(0.5), 0.01);
}



TEST(PeakMotion, cut_steps_change_nothing)
{
  EXPECT_NEAR(peak_of_sine(10., 1e-3, true), peak_of_sine(10., 1e-3, false), 5e-3);
}



TEST(PeakMotion, displacement_is_relative_to_the_base)
{
  PeakMotion   peaks(0.);
  const double rest[2] = {0., 0.}, u[2] = {0.3, -0.1}, v[2] = {0.2, 0.}, base[2] = {0.25, 0.};
  peaks.start(rest, 2);
  peaks.add(u, v, 0.1, base);
  EXPECT_DOUBLE_EQ(peaks.peak_displacement()[0], 0.3 - 0.25);
  EXPECT_DOUBLE_EQ(peaks.peak_displacement()[1], 0.1);
  EXPECT_DOUBLE_EQ(peaks.peak_acceleration()[0], 2.); // no filter
}
