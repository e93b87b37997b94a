// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/rest_watch.h>
#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>

namespace hybrid
{
  namespace
  {
    /// Steps of 0.1 s at a constant speed. @return whether it rests at the end.
    bool look(RestWatch &watch, const double from, const double to, const double fastest)
    {
      for (int k = 1; from + 0.1 * k < to + 0.05; ++k)
        watch.look(from + 0.1 * k, fastest);
      return watch.is_at_rest();
    }
  } // namespace



  TEST(RestWatch, WaitsForASecondBelowTheSpeed)
  {
    RestWatch watch(1e-3, 2.);
    EXPECT_FALSE(look(watch, 0., 2.9, 0.)) << "shaking may begin late: it counts from its end";
    EXPECT_TRUE(look(watch, 2.9, 3.1, 0.));
    EXPECT_FALSE(look(watch, 3.1, 3.2, 2e-3)) << "it moves again";
    EXPECT_FALSE(look(watch, 3.2, 4.1, 0.9e-3));
    EXPECT_TRUE(look(watch, 4.1, 4.4, 0.9e-3));
  }



  TEST(RestWatch, WithoutASpeedNothingRests)
  {
    RestWatch watch(0., 0.);
    EXPECT_FALSE(watch.is_on());
    EXPECT_FALSE(look(watch, 0., 100., 0.));
  }



  TEST(RestWatch, GoesOnAfterAResume)
  {
    RestWatch watch(1e-3, 0.), again(1e-3, 0.);
    look(watch, 0., 5., 1.);
    look(watch, 5., 5.6, 0.);
    restart::Archive writer = restart::Archive::writer();
    writer(watch);
    restart::Archive reader = restart::Archive::reader(writer.content());
    reader(again);
    EXPECT_FALSE(look(again, 5.6, 5.8, 0.));
    EXPECT_TRUE(look(again, 5.8, 6.2, 0.));
  }
} // namespace hybrid
