// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_source.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace hybrid::scene::test
{
  namespace
  {
    /// The recipe of the developer guide: two opposite steps of 1 m/s2, half of the duration each.
    MotionSource steps_source()
    {
      return {"steps",
              [](const MotionParameters &parameters, const double time_step, InputMotion &input) {
                const int           half = static_cast<int>(0.5 * parameters.duration / time_step);
                std::vector<double> a(2 * half + 1, 1.);
                std::fill(a.begin() + half, a.end(), -1.);
                input.motion = Motion(time_step, a);
                input.notes.push_back("two steps");
              }};
    }
  } // namespace



  TEST(MotionSource, AnotherOneIsAFunctionAndALine)
  {
    std::vector<MotionSource> sources = motion_sources();
    sources.push_back(steps_source());
    MotionParameters p;
    p.type     = "steps";
    p.duration = 2.;
    p.peak     = 3.;
    TimeParameters time;
    time.time_step          = 0.01;
    time.end_time           = 4.;
    const InputMotion input = make_input_motion(p, time, sources);
    EXPECT_EQ(input.motion.peak_acceleration(), 3.) << "scaled as all motions are";
    EXPECT_NEAR(input.motion.duration(), 2., 1e-12);
    ASSERT_EQ(input.notes.size(), 2u) << "its own, and that the run is longer";
    EXPECT_EQ(input.notes[0], "two steps");
    EXPECT_THROW(make_input_motion(p, time), InputError) << "the program has no such source";
  }



  TEST(MotionSource, NamesAreDifferent)
  {
    for (const MotionSource &source : motion_sources())
      EXPECT_EQ(find_motion_source(source.name, motion_sources()), &source);
    EXPECT_EQ(find_motion_source("cosine", motion_sources()), nullptr);
  }
} // namespace hybrid::scene::test
