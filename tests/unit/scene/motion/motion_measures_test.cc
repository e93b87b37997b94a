// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/motion_measures.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::scene::test
{
  TEST(MotionMeasures, OfASine)
  {
    const double        f = 2., w = 2. * M_PI * f, dt = 1e-3;
    std::vector<double> a;
    for (int i = 0; i <= 20000; ++i)
      a.push_back(3. * std::sin(w * i * dt));
    const MotionMeasures found = measure(Motion(dt, a));
    EXPECT_NEAR(found.peak_acceleration, 3., 1e-3);
    EXPECT_NEAR(found.peak_velocity, 2. * 3. / w, 1e-3); // from rest: 1 - cos
    EXPECT_NEAR(found.velocity_over_acceleration(), 2. / w, 1e-3);
    EXPECT_NEAR(found.significant_duration, 18., 0.1);
    EXPECT_NEAR(found.spectral_period, 0.5, 0.03);
    EXPECT_NEAR(found.spectral_peak, 3. / (2. * 0.05), 2.); // resonance, near the period looked at
  }



  TEST(MotionMeasures, OfNoMotion)
  {
    EXPECT_EQ(measure(Motion()).velocity_over_acceleration(), 0.);
    EXPECT_EQ(measure(Motion(0.01, std::vector<double>(10, 0.))).spectral_peak, 0.);
  }
} // namespace hybrid::scene::test
