// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/ground_motion.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::scene;

  /// 2 m/s2 for one second from t = 0.25 s, in the direction (0.6, 0.8).
  GroundMotion given(const bool outcrop)
  {
    MotionParameters parameters;
    parameters.outcrop = outcrop;
    parameters.angle   = std::atan2(0.8, 0.6) * 180. / M_PI;
    parameters.start   = 0.25;
    return {Motion(0.5, {2., 2., 2.}), parameters};
  }

  void expect_near(const Vec2 &found, const double expected)
  {
    EXPECT_NEAR(found.x(), 0.6 * expected, 1e-14);
    EXPECT_NEAR(found.y(), 0.8 * expected, 1e-14);
  }
} // namespace



TEST(GroundMotion, an_outcrop_moves_twice_as_much_as_the_upgoing_wave)
{
  const double t = 0.75, v = 2. * 0.5, u = 0.5 * 2. * 0.5 * 0.5;
  for (const bool outcrop : {true, false})
    {
      const GroundMotion motion  = given(outcrop);
      const double       to_rock = outcrop ? 1. : 2.;
      expect_near(motion.outcrop_acceleration(t), to_rock * 2.);
      expect_near(motion.outcrop_velocity(t), to_rock * v);
      expect_near(motion.outcrop_displacement(t), to_rock * u);
      expect_near(motion.upgoing_velocity(t), 0.5 * to_rock * v);
      expect_near(motion.upgoing_displacement(t), 0.5 * to_rock * u);
      EXPECT_EQ(motion.outcrop().peak_acceleration(), to_rock * 2.);
    }
}



TEST(GroundMotion, the_vertical_component_of_a_record_comes_beside_the_other)
{
  MotionParameters parameters;
  parameters.start               = 0.25;
  parameters.repetitions         = 2;
  parameters.repetition_interval = 10.;
  const Motion along(0.5, {2., 2., 2.}), upwards(0.25, {0., -4., 0., 0., 0., 4., 0.});
  for (const bool outcrop : {true, false})
    {
      parameters.outcrop = outcrop;
      const GroundMotion both(along, parameters, upwards), alone(along, parameters);
      const double       to_rock = outcrop ? 1. : 2.;
      EXPECT_EQ(both.end(), 0.25 + 10. + 1.5);
      for (const double t : {0., 0.5, 1.1, 1.7, 5., 10.5, 11.6})
        {
          const auto once = [&](const double since) { return to_rock * upwards.velocity(since); };
          EXPECT_EQ(both.outcrop_velocity(t).x(), alone.outcrop_velocity(t).x());
          EXPECT_EQ(alone.outcrop_velocity(t).y(), 0.);
          EXPECT_NEAR(both.outcrop_velocity(t).y(), once(t - 0.25) + once(t - 10.25), 1e-14);
          EXPECT_NEAR(both.upgoing_velocity(t).y(), 0.5 * both.outcrop_velocity(t).y(), 1e-14);
        }
      EXPECT_NEAR(both.outcrop_acceleration(0.5).y(), -4. * to_rock, 1e-14);
      EXPECT_NEAR(both.outcrop_displacement(0.5).y(), to_rock * upwards.displacement(0.25), 1e-14);
      EXPECT_EQ(both.vertical_outcrop().peak_acceleration(), 4. * to_rock);
    }
}



TEST(GroundMotion, nothing_moves_before_the_start_or_without_a_motion)
{
  expect_near(given(true).outcrop_acceleration(0.2), 0.);
  expect_near(given(true).outcrop_displacement(0.2), 0.);
  EXPECT_FALSE(given(true).empty());
  EXPECT_TRUE(GroundMotion().empty());
  expect_near(GroundMotion().upgoing_velocity(1.), 0.);
  expect_near(GroundMotion().outcrop_acceleration(0.), 0.);
}



TEST(GroundMotion, comes_again_where_the_last_event_has_left_the_ground)
{
  MotionParameters parameters;
  parameters.start               = 0.25;
  parameters.repetitions         = 3;
  parameters.repetition_interval = 4.;
  const GroundMotion motion{Motion(0.5, {2., 2., 2.}), parameters}; // leaves 2 m/s
  EXPECT_EQ(motion.end(), 0.25 + 8. + 1.);
  for (int event = 0; event < 3; ++event)
    {
      const double start = 0.25 + 4. * event;
      EXPECT_NEAR(motion.outcrop_acceleration(start + 0.5).x(), 2., 1e-14);
      EXPECT_EQ(motion.outcrop_acceleration(start + 2.).x(), 0.);
      EXPECT_NEAR(motion.outcrop_velocity(start + 0.5).x(), 2. * event + 1., 1e-14);
      // Each event left 1 m after its second, and 2 m/s from then on.
      double u = 0.25;
      for (int before = 0; before < event; ++before)
        u += 1. + 2. * (4. * (event - before) + 0.5 - 1.);
      EXPECT_NEAR(motion.outcrop_displacement(start + 0.5).x(), u, 1e-13);
    }
  EXPECT_NEAR(motion.outcrop_velocity(100.).x(), 6., 1e-14);
}
