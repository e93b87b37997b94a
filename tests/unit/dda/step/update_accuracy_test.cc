// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/update_accuracy.h>

#include <gtest/gtest.h>

using hybrid::dda::UpdateAccuracy;



TEST(UpdateAccuracy, a_tenth_of_what_the_last_step_left)
{
  UpdateAccuracy accuracy;
  EXPECT_EQ(accuracy.part(0), UpdateAccuracy::finest);
  accuracy.saw(0, 1e-3);
  EXPECT_DOUBLE_EQ(accuracy.part(0), 1e-4);
  EXPECT_EQ(accuracy.part(1), UpdateAccuracy::finest);
  accuracy.saw(0, 20.);
  EXPECT_EQ(accuracy.part(0), UpdateAccuracy::coarsest);
  accuracy.saw(UpdateAccuracy::longest, 1.);
  EXPECT_EQ(accuracy.part(UpdateAccuracy::longest), UpdateAccuracy::finest);
}



// The linear solver's part of what is left must not keep later steps coarse.
TEST(UpdateAccuracy, finds_back_where_the_conditions_no_longer_change)
{
  UpdateAccuracy accuracy;
  accuracy.saw(0, 1.);
  int steps = 0;
  for (; accuracy.part(0) > UpdateAccuracy::finest; ++steps)
    accuracy.saw(0, accuracy.part(0));
  EXPECT_LE(steps, 5); // from 3e-4 to 1e-6, a tenth each, and round-off
}
