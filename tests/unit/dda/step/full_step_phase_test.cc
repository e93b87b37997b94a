// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/full_step_phase.h>

#include <gtest/gtest.h>

#include <limits>

using hybrid::dda::FullStepPhase;



TEST(FullStepPhase, as_many_as_are_allowed)
{
  FullStepPhase updates;
  EXPECT_FALSE(updates.go_on());
  updates.begin(3, 1.);
  for (const double residual : {1.5, 1.2, 1.1})
    {
      EXPECT_TRUE(updates.go_on());
      updates.judge(residual);
    }
  EXPECT_FALSE(updates.go_on());
  EXPECT_EQ(updates.first_residual(), 1.);
  updates.begin(0, 1.);
  EXPECT_FALSE(updates.go_on());
}



TEST(FullStepPhase, those_that_lead_away_are_given_up)
{
  for (const double far : {101., std::numeric_limits<double>::quiet_NaN()})
    {
      FullStepPhase updates;
      updates.begin(9, 1.);
      updates.judge(30.);
      EXPECT_TRUE(updates.go_on());
      updates.judge(far);
      EXPECT_FALSE(updates.go_on());
    }
}



TEST(FullStepPhase, those_in_a_circle_are_given_up)
{
  FullStepPhase updates;
  updates.begin(9, 1.);
  for (const double residual : {0.8, 0.06, 0.3})
    updates.judge(residual);
  EXPECT_TRUE(updates.go_on());
  updates.judge(0.8 * (1. + 1e-9));
  EXPECT_FALSE(updates.go_on());
}



TEST(FullStepPhase, none_near_balance)
{
  FullStepPhase updates;
  updates.begin(9, 1e-4);
  EXPECT_FALSE(updates.go_on());
  updates.begin(9, 1e-2);
  EXPECT_TRUE(updates.go_on());
}
