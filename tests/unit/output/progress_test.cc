// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/progress.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace hybrid::output
{
  namespace
  {
    /// 1000 steps of 1 ms, 10 ms of wall time and 3 iterations each.
    std::string run(const bool is_terminal)
    {
      std::ostringstream out;
      double             now = 50.;
      Progress           progress(out, is_terminal, 0., 1., [&now] { return now; });
      for (int step = 1; step <= 1000; ++step)
        {
          now += 0.01;
          progress.update(1e-3 * step, step, 3 * step);
        }
      progress.finish();
      return out.str();
    }


    TEST(Progress, PlainLinesAreSparse)
    {
      const std::string text = run(false);
      const auto        n    = std::count(text.begin(), text.end(), '\n');
      EXPECT_GE(n, 10);
      EXPECT_LE(n, 11);
      EXPECT_EQ(text.find('\r'), std::string::npos);
      EXPECT_NE(text.find("100.0 %  t = 1.000 of 1 s  left 0:00  100 steps/s  3.0 iterations/step"),
                std::string::npos)
        << text;
    }


    TEST(Progress, TerminalLineIsRedrawnInPlace)
    {
      const std::string text = run(true);
      EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
      EXPECT_GE(std::count(text.begin(), text.end(), '\r'), 45);
      EXPECT_NE(text.find("[############............]  50.4 %  t = 0.504 of 1 s  left 0:05"),
                std::string::npos)
        << text;
    }


    TEST(Progress, DurationsReadLikeAClock)
    {
      EXPECT_EQ(format_duration(7.4), "0:07");
      EXPECT_EQ(format_duration(750.), "12:30");
      EXPECT_EQ(format_duration(11100.), "3:05:00");
      EXPECT_EQ(format_duration(-1.), "0:00");
    }
  } // namespace
} // namespace hybrid::output
