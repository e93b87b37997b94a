// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/clock.h>
#include <hybrid/step_plan.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid
{
  namespace
  {
    /// Ends of the steps of a run, some of which fail.
    std::vector<double> cut_run(const double time_step, const double end)
    {
      Clock               clock(time_step, end, 6);
      std::vector<double> ends;
      for (int tried = 1; !clock.at_end(); ++tried)
        if (tried % 37 == 0 || tried % 41 == 0)
          clock.shorten_step();
        else
          {
            clock.accept();
            ends.push_back(clock.time());
          }
      return ends;
    }



    /// The same of one that follows, of which none fails.
    std::vector<double>
    following_run(const std::vector<StepLevel> &plan, const double time_step, const double end)
    {
      Clock clock(time_step, end, 6);
      clock.follow(plan);
      std::vector<double> ends;
      for (; !clock.at_end(); clock.accept())
        {
          EXPECT_NEAR(std::remainder(clock.time(), clock.next_step()), 0., 1e-12);
          ends.push_back(clock.time() + clock.next_step());
        }
      return ends;
    }



    TEST(StepPlan, of_whole_steps_is_empty)
    {
      EXPECT_TRUE(step_plan({0.1, 0.2, 0.30000000001, 0.4}, 0.1).empty());
      EXPECT_TRUE(step_plan({}, 0.1).empty());
    }



    TEST(StepPlan, has_the_times_from_which_steps_are_shorter)
    {
      const auto plan = step_plan({0.1, 0.2, 0.25, 0.3, 0.325, 0.35, 0.4, 0.5, 0.6}, 0.1);
      ASSERT_EQ(plan.size(), 4u);
      const std::vector<StepLevel> expected = {{0.2, 1}, {0.3, 2}, {0.35, 1}, {0.4, 0}};
      for (std::size_t i = 0; i < plan.size(); ++i)
        {
          EXPECT_DOUBLE_EQ(plan[i].from, expected[i].from);
          EXPECT_EQ(plan[i].halvings, expected[i].halvings);
        }
    }



    TEST(StepPlan, makes_a_run_in_half_the_step_take_two_steps_for_each)
    {
      const std::vector<double> run = cut_run(1e-2, 20.);
      ASSERT_GT(run.size(), 2500u); // whole steps: 2000
      const std::vector<double> half = following_run(step_plan(run, 1e-2), 5e-3, 20.);
      ASSERT_EQ(half.size(), 2 * run.size());
      for (std::size_t i = 0; i < run.size(); ++i)
        EXPECT_NEAR(half[2 * i + 1], run[i], 1e-12);
    }



    TEST(StepPlan, keeps_a_run_in_twice_the_step_on_its_grid)
    {
      const std::vector<double> run   = cut_run(1e-2, 20.);
      const std::vector<double> twice = following_run(step_plan(run, 1e-2), 2e-2, 20.);
      EXPECT_GT(twice.size(), run.size() / 2 - 1);
      EXPECT_LT(twice.size(), 3 * run.size() / 4);
      EXPECT_NEAR(twice.back(), 20., 1e-10);
    }



    TEST(StepPlan, leaves_steps_that_fail_to_be_halved_further)
    {
      Clock clock(0.1, 1., 3);
      clock.follow({{0.1, 1}, {0.2, 0}});
      clock.accept();
      EXPECT_DOUBLE_EQ(clock.next_step(), 0.05);
      EXPECT_TRUE(clock.shorten_step());
      EXPECT_DOUBLE_EQ(clock.next_step(), 0.025);
      EXPECT_TRUE(clock.shorten_step());
      EXPECT_FALSE(clock.shorten_step());
      while (clock.time() < 0.199)
        clock.accept();
      EXPECT_DOUBLE_EQ(clock.next_step(), 0.025); // after 8 good ones, as without a plan
    }
  } // namespace
} // namespace hybrid
