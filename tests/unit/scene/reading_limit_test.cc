// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/reading_limit.h>

#include <gtest/gtest.h>

#include <new>

namespace hybrid::scene
{
  namespace
  {
    /// So many additions, which no compiler leaves out.
    void count(const double n)
    {
      volatile double i = 0.;
      while (i < n)
        i = i + 1.;
    }


    TEST(ReadingLimit, EndlessReadingEndsWithASentence)
    {
      testing::FLAGS_gtest_death_test_style = "threadsafe";
      EXPECT_EXIT(
        {
          const ReadingLimit limit("slope.geo", 0.2);
          count(1e300);
        },
        testing::ExitedWithCode(2),
        "^error: slope.geo: gmsh has not come to an end of this file after 0.2 s of computing: look "
        "for a list or loop .*\\.\n$");
    }


    void allocate(const std::size_t size)
    {
      ::operator delete(::operator new(size)); // a new expression might be left out
    }


    TEST(ReadingLimit, MemoryIsRefusedWhileItLives)
    {
      const std::size_t size = 3000000000;
      {
        const ReadingLimit limit("slope.geo");
        EXPECT_THROW(allocate(size), std::bad_alloc);
        EXPECT_NO_THROW(allocate(size / 30));
      }
      EXPECT_NO_THROW(allocate(size));
    }


    TEST(ReadingLimit, TimeIsFreeAfterwards)
    {
      {
        const ReadingLimit limit("slope.geo", 0.05);
      }
      count(2e8); // some tenths of a second
    }
  } // namespace
} // namespace hybrid::scene
