// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/interruption.h>

#include <gtest/gtest.h>

#include <csignal>

using hybrid::Interruption;



TEST(Interruption, notes_the_first_signal)
{
  for (const int number : {SIGINT, SIGTERM})
    {
      const Interruption interruption;
      EXPECT_FALSE(interruption.is_requested());
      std::raise(number);
      EXPECT_TRUE(interruption.is_requested());
    }
}



TEST(Interruption, a_second_signal_ends_the_program)
{
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
    {
      const Interruption interruption;
      std::raise(SIGINT);
      std::raise(SIGINT);
    },
    testing::KilledBySignal(SIGINT),
    "");
}
