// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/scene_card.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    /// A Ricker wavelet of 5 Hz in steps of @p dt [s].
    scene::Motion wavelet(const double dt)
    {
      std::vector<double> a;
      for (double t = -0.3; t <= 0.3; t += dt)
        {
          const double s = std::pow(M_PI * 5. * t, 2);
          a.push_back((1. - 2. * s) * std::exp(-s));
        }
      return {dt, a};
    }


    TEST(SceneCard, TheHighestFrequencyDoesNotDependOnTheSpacing)
    {
      // 95 % of a Ricker wavelet's energy are below 1.664 of its frequency.
      EXPECT_NEAR(highest_frequency(wavelet(1e-2)), 8.32, 0.13);
      EXPECT_EQ(highest_frequency(wavelet(1e-3)), highest_frequency(wavelet(1e-2)));
      EXPECT_EQ(highest_frequency(wavelet(1e-6)), highest_frequency(wavelet(1e-2)));
      EXPECT_EQ(highest_frequency(scene::Motion()), 0.);
    }
  } // namespace
} // namespace hybrid::output
