// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/open_close_parts.h>

#include <gtest/gtest.h>

using hybrid::dda::Circles;
using hybrid::dda::PathProgress;

TEST(PathProgress, advances_while_directions_can_be_taken_or_the_residual_falls)
{
  PathProgress progress;
  for (const double residual : {1., 2., 1.5, 3.})
    {
      progress.saw(0.02, residual, 1.);
      EXPECT_FALSE(progress.holds());
    }
  for (const double residual : {0.6, 0.4, 0.25})
    {
      progress.saw(0., residual, 1.);
      EXPECT_FALSE(progress.holds());
    }
}



TEST(PathProgress, holds_after_two_directions_that_brought_nothing)
{
  PathProgress progress;
  progress.saw(0.5, 1., 1.);
  progress.saw(0.001, 0.9, 1.);
  EXPECT_FALSE(progress.holds());
  progress.saw(0.001, 0.8, 1.);
  EXPECT_TRUE(progress.holds());
}



// Each contact goes its own part of the way: the products fall though one of them holds all up.
TEST(PathProgress, falling_products_are_an_advance)
{
  PathProgress progress;
  double       product = 1.;
  for (int k = 0; k < 10; ++k, product *= 0.5)
    {
      progress.saw(0.001, 2., product);
      EXPECT_FALSE(progress.holds());
    }
}



// Every second residual is far below the one before it, and none below the least.
TEST(PathProgress, to_and_fro_is_no_advance)
{
  PathProgress progress;
  progress.saw(0.5, 0.02, 1.);
  progress.saw(0.001, 1.5, 1.);
  progress.saw(0.001, 0.019, 1.);
  EXPECT_TRUE(progress.holds());
}



TEST(Circles, close_where_a_residual_of_two_or_three_updates_ago_comes_back)
{
  Circles two;
  EXPECT_FALSE(two.close(1., 0.5));
  EXPECT_TRUE(two.close(0.5, 1.));
  Circles three;
  EXPECT_FALSE(three.close(1., 0.5));
  EXPECT_FALSE(three.close(0.5, 0.7));
  EXPECT_TRUE(three.close(0.7, 1. + 1e-7));
}



// A residual that stays is slow, not a circle.
TEST(Circles, do_not_close_where_the_residual_stays_or_is_new)
{
  Circles circles;
  EXPECT_FALSE(circles.close(1., 1.));
  EXPECT_FALSE(circles.close(1., 0.9));
  EXPECT_FALSE(circles.close(0.9, 0.8));
}
