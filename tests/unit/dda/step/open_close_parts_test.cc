// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/open_close_parts.h>

#include <gtest/gtest.h>

using hybrid::dda::PathProgress;

TEST(PathProgress, advances_while_directions_can_be_taken_or_the_residual_falls)
{
  PathProgress progress;
  for (const double residual : {1., 2., 1.5, 3.})
    {
      progress.saw(0.02, residual);
      EXPECT_FALSE(progress.holds());
    }
  for (const double residual : {0.6, 0.4, 0.25})
    {
      progress.saw(0., residual);
      EXPECT_FALSE(progress.holds());
    }
}



TEST(PathProgress, holds_after_two_directions_that_brought_nothing)
{
  PathProgress progress;
  progress.saw(0.5, 1.);
  progress.saw(0.001, 0.9);
  EXPECT_FALSE(progress.holds());
  progress.saw(0.001, 0.8);
  EXPECT_TRUE(progress.holds());
}



// Every second residual is far below the one before it, and none below the least.
TEST(PathProgress, to_and_fro_is_no_advance)
{
  PathProgress progress;
  progress.saw(0.5, 0.02);
  progress.saw(0.001, 1.5);
  progress.saw(0.001, 0.019);
  EXPECT_TRUE(progress.holds());
}
