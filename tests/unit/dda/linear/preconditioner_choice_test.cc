// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/preconditioner_choice.h>

#include <gtest/gtest.h>

namespace
{
  using hybrid::dda::PreconditionerChoice;

  /// A factor is worth 100 iterations with sweeps, one with it 2.
  const PreconditionerChoice::Costs costs{1., 2., 100.};
} // namespace



TEST(PreconditionerChoice, few_sweeps_serve_for_ever)
{
  PreconditionerChoice choice;
  for (int k = 0; k < 1000; ++k)
    choice.swept(2, true, costs);
  EXPECT_FALSE(choice.uses_factor());
}



TEST(PreconditionerChoice, many_sweeps_buy_a_factor_once_they_have_cost_as_much)
{
  PreconditionerChoice choice;
  int                  solutions = 0;
  for (; !choice.uses_factor(); ++solutions)
    choice.swept(30, true, costs);
  EXPECT_EQ(solutions, 4); // each 28 dearer than with a factor
}



TEST(PreconditionerChoice, sweeps_that_fail_are_given_up_where_a_factor_costs_no_more)
{
  PreconditionerChoice choice;
  EXPECT_EQ(choice.sweep_limit(costs), 102);
  EXPECT_EQ(choice.sweep_limit({1., 2., 10.}), 40);
  choice.swept(102, false, costs);
  EXPECT_TRUE(choice.uses_factor());
}



TEST(PreconditionerChoice, an_old_factor_is_kept_until_it_has_cost_as_much_as_a_new_one)
{
  PreconditionerChoice choice;
  choice.swept(102, false, costs);
  EXPECT_EQ(choice.old_factor_limit(costs), 50);
  int solutions = 0;
  for (; choice.old_factor_limit(costs) > 0; ++solutions)
    {
      choice.used_old_factor(6, true, costs);
      choice.solved(6, 0, costs);
    }
  EXPECT_EQ(solutions, 10); // each 10 dearer than with a new one
}



TEST(PreconditionerChoice, old_factors_that_fail_are_passed_over_but_now_and_then)
{
  PreconditionerChoice choice;
  choice.swept(102, false, costs);
  for (int k = 0; k < 2; ++k)
    choice.used_old_factor(50, false, costs);
  int tried = 0;
  for (int k = 0; k < 24; ++k)
    tried += choice.old_factor_limit(costs) > 0 ? 1 : 0;
  EXPECT_EQ(tried, 3);
}



// A factor for each matrix is dearer than sweeps were: back to these, for longer than before.
TEST(PreconditionerChoice, a_factor_that_does_not_pay_is_given_up)
{
  PreconditionerChoice choice;
  int                  swept[2];
  for (int &count : swept)
    {
      for (count = 0; !choice.uses_factor(); ++count)
        choice.swept(30, true, costs);
      for (int k = 0; k < 8; ++k)
        choice.solved(1, 1, costs);
      EXPECT_FALSE(choice.uses_factor());
    }
  EXPECT_GE(swept[1], 2 * swept[0] - 1);
}



// What it has cost is spread over all that it serves, not over the first few solutions.
TEST(PreconditionerChoice, a_factor_is_not_judged_before_another_one_is_needed)
{
  PreconditionerChoice choice;
  while (!choice.uses_factor())
    choice.swept(12, true, costs); // eight of them cost less than a factor
  choice.solved(1, 1, costs);
  for (int k = 0; k < 40; ++k)
    {
      ASSERT_GT(choice.old_factor_limit(costs), 0);
      choice.used_old_factor(2, true, costs);
      choice.solved(2, 0, costs);
      ASSERT_TRUE(choice.uses_factor());
    }
  choice.solved(1, 1, costs);
  EXPECT_TRUE(choice.uses_factor()); // the first one has paid
  for (int k = 0; k < 8; ++k)
    choice.solved(1, 1, costs);
  EXPECT_FALSE(choice.uses_factor());
}



TEST(PreconditionerChoice, a_factor_that_pays_is_kept_while_what_sweeps_cost_is_remembered)
{
  PreconditionerChoice choice;
  choice.swept(102, false, costs);
  for (int k = 0; k < 80; ++k)
    choice.solved(1, 1, costs);
  EXPECT_TRUE(choice.uses_factor());
  for (int k = 0; k < 400; ++k)
    choice.solved(1, 1, costs);
  EXPECT_FALSE(choice.uses_factor()); // sweeps may serve by now
}
