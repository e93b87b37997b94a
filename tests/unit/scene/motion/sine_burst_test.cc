// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/sine_burst.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace hybrid::scene::test
{
  namespace
  {
    MotionParameters burst(const double cycles, const double taper, const bool corrected)
    {
      MotionParameters parameters;
      parameters.type                = "sine";
      parameters.frequency           = 2.;
      parameters.cycles              = cycles;
      parameters.taper               = taper;
      parameters.baseline_correction = corrected;
      return parameters;
    }
  } // namespace


  TEST(SineBurst, plain_burst_is_a_sine_and_ends_displaced_at_rest)
  {
    const Motion motion = make_sine_burst(burst(5., 0., false), 0.01);
    EXPECT_NEAR(motion.duration(), 2.5, 1e-9);
    const double w = 4. * M_PI;
    for (double t = 0.; t < 2.5; t += 0.0137)
      {
        EXPECT_NEAR(motion.acceleration(t), std::sin(w * t), 1e-4);
        EXPECT_NEAR(motion.velocity(t), (1. - std::cos(w * t)) / w, 1e-4);
        EXPECT_NEAR(motion.displacement(t), (t - std::sin(w * t) / w) / w, 1e-4);
      }
    EXPECT_NEAR(motion.velocity(3.), 0., 1e-12);
    EXPECT_NEAR(motion.displacement(3.), 2.5 / w, 1e-4);
    EXPECT_EQ(motion.acceleration(2.6), 0.);
  }


  TEST(SineBurst, taper_rises_and_falls_as_a_squared_sine)
  {
    const Motion motion = make_sine_burst(burst(8., 2., false), 1e-3);
    const double T      = 4.;
    for (double t = 0.; t < T; t += 0.0123)
      {
        const double edge = std::min(t, T - t);
        const double rise = edge < 1. ? std::pow(std::sin(0.5 * M_PI * edge), 2) : 1.;
        EXPECT_NEAR(motion.acceleration(t), rise * std::sin(4. * M_PI * t), 1e-4);
      }
  }


  TEST(SineBurst, corrected_burst_ends_at_rest_where_it_began)
  {
    for (const double cycles : {1., 3.5, 10.})
      {
        const Motion motion = make_sine_burst(burst(cycles, 0.25 * cycles, true), 1e-3);
        const double T      = motion.duration();
        EXPECT_LT(std::abs(motion.velocity(2. * T)), 1e-13 * T);
        EXPECT_LT(std::abs(motion.displacement(2. * T)), 1e-12 * T * T);
      }
  }


  TEST(SineBurst, sampling_fits_the_time_step)
  {
    for (const double step : {1e-3, 7e-3, 0.02})
      {
        const double ratio = step / make_sine_burst(burst(4., 1., false), step).time_step();
        EXPECT_NEAR(ratio, std::round(ratio), 1e-12);
        EXPECT_GE(ratio * (0.5 / step), 399.);
      }
  }


  TEST(SineBurst, automatic_taper_is_two_cycles_or_half_of_a_short_burst)
  {
    const double automatic = MotionParameters().taper;
    for (const auto &[cycles, taper] : {std::pair(10., 2.), std::pair(2., 1.)})
      {
        const Motion found  = make_sine_burst(burst(cycles, automatic, false), 1e-3);
        const Motion wanted = make_sine_burst(burst(cycles, taper, false), 1e-3);
        for (int i = 0; i < 100; ++i)
          EXPECT_EQ(found.acceleration(0.013 * i), wanted.acceleration(0.013 * i));
      }
  }


  TEST(SineBurst, too_long_a_taper_or_burst_is_refused)
  {
    EXPECT_THROW(make_sine_burst(burst(1e12, 0., true), 1e-3), InputError);
    EXPECT_THROW(make_sine_burst(burst(4., 2.1, true), 1e-3), InputError);
  }
} // namespace hybrid::scene::test
