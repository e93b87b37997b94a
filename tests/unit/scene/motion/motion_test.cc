// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/motion.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::scene::test
{
  TEST(Motion, IntegralsOfALinearAccelerationAreExact)
  {
    // a = 3 t, v = 1.5 t^2, u = 0.5 t^3
    const Motion motion(0.25, {0., 0.75, 1.5, 2.25, 3.});
    for (const double t : {0., 0.1, 0.25, 0.6, 0.999, 1.})
      {
        EXPECT_NEAR(motion.acceleration(t), 3. * t, 1e-15);
        EXPECT_NEAR(motion.velocity(t), 1.5 * t * t, 1e-15);
        EXPECT_NEAR(motion.displacement(t), 0.5 * t * t * t, 1e-15);
      }
    EXPECT_DOUBLE_EQ(motion.duration(), 1.);
    EXPECT_DOUBLE_EQ(motion.peak_acceleration(), 3.);
  }


  TEST(Motion, RestBeforeAndSteadyMotionAfterTheRecord)
  {
    const Motion motion(0.5, {1., 1., 1.});
    EXPECT_EQ(motion.acceleration(-0.1), 0.);
    EXPECT_EQ(motion.velocity(-0.1), 0.);
    EXPECT_EQ(motion.displacement(-0.1), 0.);
    EXPECT_EQ(motion.acceleration(1.1), 0.);
    EXPECT_DOUBLE_EQ(motion.velocity(3.), 1.);
    EXPECT_DOUBLE_EQ(motion.displacement(3.), 0.5 + 2.);
  }


  TEST(Motion, DisplacementIsContinuousAndVelocityItsDerivative)
  {
    const Motion motion(0.1, {0.3, -1., 2., 0.5, -0.7, 0.1});
    for (double t = 0.01; t < 0.49; t += 0.0137)
      {
        const double e = 1e-5;
        EXPECT_NEAR((motion.displacement(t + e) - motion.displacement(t - e)) / (2. * e),
                    motion.velocity(t),
                    1e-8);
        EXPECT_NEAR((motion.velocity(t + e) - motion.velocity(t - e)) / (2. * e),
                    motion.acceleration(t),
                    1e-4);
      }
  }


  TEST(Motion, ScalingIsLinear)
  {
    const Motion motion(0.1, {0., 1., -2., 0.});
    const Motion scaled = motion.scaled(-3.);
    EXPECT_DOUBLE_EQ(scaled.peak_acceleration(), 6.);
    EXPECT_DOUBLE_EQ(scaled.velocity(0.17), -3. * motion.velocity(0.17));
    EXPECT_DOUBLE_EQ(scaled.displacement(0.23), -3. * motion.displacement(0.23));
  }


  TEST(Motion, EmptyMotionIsRest)
  {
    const Motion motion;
    EXPECT_TRUE(motion.empty());
    EXPECT_EQ(motion.acceleration(1.), 0.);
    EXPECT_EQ(motion.velocity(1.), 0.);
    EXPECT_EQ(motion.displacement(1.), 0.);
    EXPECT_EQ(motion.duration(), 0.);
    EXPECT_EQ(motion.peak_acceleration(), 0.);
  }
} // namespace hybrid::scene::test
