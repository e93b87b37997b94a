// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/clock.h>
#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>

#include <cmath>

using hybrid::Clock;



TEST(Clock, does_not_drift_over_a_million_steps)
{
  Clock clock(1e-3, 1000., 8);
  long  steps = 0;
  for (; !clock.at_end(); ++steps)
    {
      ASSERT_DOUBLE_EQ(clock.next_step(), 1e-3);
      clock.accept();
    }
  EXPECT_EQ(steps, 1000000);
  EXPECT_NEAR(clock.time(), 1000., 1e-12 * 1000.);
}



TEST(Clock, ends_after_whole_steps_however_the_end_is_rounded)
{
  for (const double end : {0.3, 0.1 + 0.2, 0.7, 1.1})
    {
      Clock clock(0.1, end, 3);
      int   steps = 0;
      for (; !clock.at_end(); ++steps)
        clock.accept();
      EXPECT_EQ(steps, std::lround(end / 0.1)) << end;
    }
  Clock part(0.1, 0.25, 3);
  int   steps = 0;
  for (; !part.at_end(); ++steps)
    part.accept();
  EXPECT_EQ(steps, 3);
}



TEST(Clock, zero_duration_is_at_its_end)
{
  EXPECT_TRUE(Clock(1e-3, 0., 4).at_end());
}



TEST(Clock, halves_a_failed_step_and_stays_where_it_is)
{
  Clock clock(0.1, 1., 2);
  clock.accept();
  EXPECT_TRUE(clock.shorten_step());
  EXPECT_DOUBLE_EQ(clock.time(), 0.1);
  EXPECT_DOUBLE_EQ(clock.next_step(), 0.05);
  EXPECT_EQ(clock.cuts(), 1);
}



TEST(Clock, refuses_below_the_smallest_step)
{
  Clock clock(0.1, 1., 2);
  EXPECT_TRUE(clock.shorten_step());
  EXPECT_TRUE(clock.shorten_step());
  EXPECT_FALSE(clock.shorten_step());
  EXPECT_DOUBLE_EQ(clock.next_step(), 0.025);
  EXPECT_FALSE(Clock(0.1, 1., 0).shorten_step());
}



TEST(Clock, grows_back_on_multiples_after_good_steps)
{
  Clock clock(0.08, 8., 3);
  for (int k = 0; k < 3; ++k)
    EXPECT_TRUE(clock.shorten_step());
  double shortest = clock.next_step(), before = shortest;
  EXPECT_DOUBLE_EQ(shortest, 0.01);
  int good = 0;
  while (clock.next_step() < 0.079)
    {
      clock.accept();
      ++good;
      const double now = clock.next_step();
      if (now > before * 1.5)
        {
          EXPECT_NEAR(now, 2. * before, 1e-15); // one doubling at a time
          EXPECT_GE(good, 8);                   // not before eight good steps
          EXPECT_NEAR(std::remainder(clock.time(), now), 0., 1e-12);
          before = now;
          good   = 0;
        }
      ASSERT_LT(clock.time(), 8.);
    }
  for (; !clock.at_end(); clock.accept())
    EXPECT_NEAR(std::remainder(clock.time(), 0.08), 0., 1e-12);
  EXPECT_NEAR(clock.time(), 8., 1e-12);
}



// Steps that fail now and then, for long: every time is a whole number of smallest steps.
TEST(Clock, failures_now_and_then_never_leave_the_grid)
{
  Clock clock(1e-2, 50., 5);
  for (long k = 1; !clock.at_end(); ++k)
    if (k % 97 == 0)
      EXPECT_TRUE(clock.shorten_step());
    else
      clock.accept();
  EXPECT_NEAR(clock.time(), 50., 1e-10);
  EXPECT_GT(clock.cuts(), 10);
}



// Halvings, and the steps until the next longer one is tried, go on where they were.
TEST(Clock, a_restored_clock_takes_the_same_steps)
{
  using hybrid::restart::Archive;
  const auto work = [](Clock &clock, const int k) {
    if (k % 13 == 0)
      clock.shorten_step();
    else
      clock.accept();
  };
  for (int moment = 1; moment < 60; ++moment)
    {
      Clock clock(1e-2, 1., 5), copy(1e-2, 1., 5);
      for (int k = 1; k < moment; ++k)
        work(clock, k);
      Archive writer = Archive::writer();
      writer(clock);
      Archive reader = Archive::reader(writer.content());
      reader(copy);
      for (int k = moment; k < 100; ++k)
        {
          ASSERT_EQ(clock.time(), copy.time());
          ASSERT_EQ(clock.next_step(), copy.next_step());
          ASSERT_EQ(clock.cuts(), copy.cuts());
          work(clock, k);
          work(copy, k);
        }
    }
}
