// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/filter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hybrid::scene::test
{
  namespace
  {
    constexpr double dt = 1e-3; // [s]


    std::vector<double> sine(const double frequency, const int n)
    {
      std::vector<double> series(n);
      for (int i = 0; i < n; ++i)
        series[i] = std::sin(2. * M_PI * frequency * i * dt);
      return series;
    }
  } // namespace


  TEST(LowPass, SinesKeepTheirPhaseAndFollowTheGain)
  {
    const double corner = 25.;
    for (const double f : {2., 10., 25., 50., 100.})
      {
        const std::vector<double> x    = sine(f, 4000);
        const std::vector<double> y    = low_pass(x, dt, corner);
        const double              w    = std::tan(M_PI * f * dt) / std::tan(M_PI * corner * dt);
        const double              gain = 1. / (1. + w * w * w * w);
        for (int i = 1000; i < 3000; ++i)
          ASSERT_NEAR(y[i], gain * x[i], 1e-6) << f << " Hz, sample " << i;
      }
  }


  TEST(LowPass, ConstantAndStraightLinePass)
  {
    std::vector<double> constant(500, 3.5), line(500);
    for (int i = 0; i < 500; ++i)
      line[i] = 1. + 0.2 * i;
    const std::vector<double> c = low_pass(constant, dt, 25.), l = low_pass(line, dt, 25.);
    for (int i = 0; i < 500; ++i)
      {
        EXPECT_NEAR(c[i], 3.5, 1e-12);
        EXPECT_NEAR(l[i], line[i], 1e-4 * 0.2 * 40.); // 40 samples are one period of the corner
      }
  }


  TEST(LowPass, IsSymmetricInTime)
  {
    std::vector<double> x = sine(7., 800);
    x[300] += 5.;
    std::vector<double> mirrored(x.rbegin(), x.rend());
    const auto          y = low_pass(x, dt, 25.);
    auto                z = low_pass(mirrored, dt, 25.);
    std::reverse(z.begin(), z.end());
    for (int i = 0; i < 800; ++i)
      EXPECT_NEAR(y[i], z[i], 2e-6);
  }


  TEST(LowPass, SpikeIsSpreadWithItsAreaKept)
  {
    std::vector<double> x(2001, 0.);
    x[1000]        = 1.;
    const auto y   = low_pass(x, dt, 25.);
    double     sum = 0.;
    for (const double value : y)
      sum += value;
    EXPECT_NEAR(sum, 1., 1e-9);
    EXPECT_EQ(std::max_element(y.begin(), y.end()) - y.begin(), 1000);
    EXPECT_LT(y[1000], 0.1);
  }


  TEST(LowPass, OffAndShortSeriesAreReturnedUnchanged)
  {
    const std::vector<double> x = {1., -2., 5.};
    EXPECT_EQ(low_pass(x, dt, 0.), x);
    EXPECT_EQ(low_pass(x, dt, 500.), x); // Nyquist
    EXPECT_EQ(low_pass({4.}, dt, 25.), std::vector<double>{4.});
    EXPECT_TRUE(low_pass({}, dt, 25.).empty());
    for (const double value : low_pass({2., 2.}, dt, 25.))
      EXPECT_NEAR(value, 2., 1e-12);
  }
} // namespace hybrid::scene::test
