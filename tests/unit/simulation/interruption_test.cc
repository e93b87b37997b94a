// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/interruption.h>

#include <gtest/gtest.h>

#include <csignal>

using hybrid::Interruption;



TEST(Interruption, notes_the_first_signal)
{
  for (const int number : {SIGINT, SIGTERM, SIGHUP})
    {
      std::signal(number, SIG_DFL);
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
      std::signal(SIGINT, SIG_DFL);
      const Interruption interruption;
      std::raise(SIGINT);
      std::raise(SIGINT);
    },
    testing::KilledBySignal(SIGINT),
    "");
}



TEST(Interruption, an_ignored_signal_stays_ignored)
{
  std::signal(SIGHUP, SIG_IGN);
  {
    const Interruption interruption;
    std::raise(SIGHUP);
    EXPECT_FALSE(interruption.is_requested());
  }
  EXPECT_EQ(std::signal(SIGHUP, SIG_DFL), SIG_IGN);
}
