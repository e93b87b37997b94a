// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/filter_reach.h>
#include <hybrid/scene/motion/filter.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr double dt = 1e-3, corner = 25.;
    constexpr int    steps = 1000;



    /// What the filter leaves at a distance from the end of a wave of four times the corner.
    double left_of_short_wave(const double distance)
    {
      std::vector<double> wave(steps);
      double              largest = 0.;
      for (const double phase : {0., 0.5 * M_PI})
        {
          for (int i = 0; i < steps; ++i)
            wave[i] = std::cos(2. * M_PI * 4. * corner * dt * (steps - 1 - i) + phase);
          const std::vector<double> filtered = scene::low_pass(wave, dt, corner);
          largest = std::max(largest, std::abs(filtered[steps - 1 - std::lround(distance / dt)]));
        }
      return largest;
    }



    TEST(FilterReach, is_where_the_filter_filters)
    {
      EXPECT_GT(left_of_short_wave(0.), 0.9); // the last value passes
      EXPECT_LT(left_of_short_wave(filter_reach(corner, steps * dt)), 0.02);
    }



    TEST(FilterReach, leaves_half_of_a_short_record)
    {
      EXPECT_EQ(filter_reach(corner, 0.08), 0.02);
      EXPECT_EQ(filter_reach(corner, 8.), 0.04);
      EXPECT_EQ(filter_reach(0., 8.), 0.);
    }
  } // namespace
} // namespace hybrid::output
