// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/step_choice.h>

#include <gtest/gtest.h>

using hybrid::choose_step;
using hybrid::StepChoice;
using hybrid::output::Summary;



/// Displacement and velocity off by @p now, and by @p half with half the step; acceleration by
/// more.
Summary::ProbableError
estimated(const double now, const double half)
{
  Summary::ProbableError error;
  error.reason.clear();
  error.step.part      = {0.3 * now, now, 10.};
  error.half_step.part = {0.3 * half, half, 10.};
  return error;
}



TEST(StepChoice, a_run_that_meets_the_target_stands)
{
  const StepChoice choice = choose_step(estimated(0.009, 0.002), 4e-3, 0.01);
  EXPECT_FALSE(choice.step);
  EXPECT_EQ(choice.unmet, "");
}



TEST(StepChoice, takes_as_many_halvings_as_a_second_order_needs)
{
  EXPECT_DOUBLE_EQ(*choose_step(estimated(0.04, 0.01), 4e-3, 0.01).step, 2e-3);
  EXPECT_DOUBLE_EQ(*choose_step(estimated(0.16, 0.04), 4e-3, 0.01).step, 1e-3);
  EXPECT_DOUBLE_EQ(*choose_step(estimated(0.04, 0.001), 4e-3, 0.0009).step,
                   1e-3); // gains no more than that
}



TEST(StepChoice, a_step_of_stable_parts_gets_shorter_than_a_part)
{
  for (const auto &[parts, divisor] : {std::pair<int, int>{2, 4}, {7, 8}, {8, 16}, {50, 64}})
    {
      Summary::ProbableError error = estimated(0.02, 0.02);
      error.parts                  = parts;
      const StepChoice choice      = choose_step(error, 0.016, 0.01);
      ASSERT_TRUE(choice.step) << parts;
      EXPECT_EQ(*choice.step, 0.016 / divisor) << parts;
    }
}



TEST(StepChoice, a_first_order_takes_more)
{
  EXPECT_DOUBLE_EQ(*choose_step(estimated(0.08, 0.04), 8e-3, 0.01).step, 1e-3);
}



TEST(StepChoice, four_halvings_at_most)
{
  EXPECT_DOUBLE_EQ(*choose_step(estimated(0.5, 0.4), 16e-3, 1e-6).step, 1e-3);
}



TEST(StepChoice, one_quantity_is_enough)
{
  Summary::ProbableError error = estimated(0.04, 0.01);
  error.step.part[0] = error.half_step.part[0] = hybrid::output::MonitorSummary::unknown;
  EXPECT_DOUBLE_EQ(*choose_step(error, 4e-3, 0.01).step, 2e-3);
}



TEST(StepChoice, halves_where_two_runs_tell_the_error)
{
  Summary::ProbableError error = estimated(0.04, 0.01);
  error.measured_from          = 8e-3;
  EXPECT_DOUBLE_EQ(*choose_step(error, 4e-3, 1e-6).step, 2e-3);
  EXPECT_FALSE(choose_step(error, 4e-3, 0.05).step);
  error.reason        = "blocks fly";
  error.runs_would_do = true;
  EXPECT_DOUBLE_EQ(*choose_step(error, 4e-3, 1.).step, 2e-3);
}



TEST(StepChoice, says_that_what_follows_a_failure_is_open)
{
  Summary::ProbableError error = estimated(0.009, 0.002);
  error.until                  = 0.456;
  EXPECT_FALSE(choose_step(error, 4e-3, 0.01).step);
  EXPECT_NE(choose_step(error, 4e-3, 0.01).unmet.find("until a joint failed at 0.456 s"),
            std::string::npos);
}



TEST(StepChoice, says_that_blocks_may_flutter_in_shorter_steps)
{
  Summary::ProbableError error = estimated(0.009, 0.002);
  error.may_flutter            = true;
  EXPECT_FALSE(choose_step(error, 4e-3, 0.01).step);
  EXPECT_NE(choose_step(error, 4e-3, 0.01).unmet.find("flutter"), std::string::npos);
  EXPECT_EQ(choose_step(error, 4e-3, 0.001).unmet, ""); // not met: shorter steps follow
}



TEST(StepChoice, says_what_it_cannot_know)
{
  Summary::ProbableError error = estimated(0.04, 0.01);
  error.reason                 = "blocks fly";
  EXPECT_FALSE(choose_step(error, 4e-3, 0.01).step);
  EXPECT_NE(choose_step(error, 4e-3, 0.01).unmet.find("blocks fly"), std::string::npos);
  EXPECT_NE(choose_step(estimated(0.04, 0.05), 4e-3, 0.01).unmet.find("half the step"),
            std::string::npos);
}
