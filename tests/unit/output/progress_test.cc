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
    std::string run(const bool is_terminal, const int width = 120)
    {
      std::ostringstream out;
      double             now = 50.;
      Progress           progress(
        out, is_terminal, 0., 1., [&now] { return now; }, [width] { return width; });
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


    TEST(Progress, WavesAloneHaveNoIterations)
    {
      std::ostringstream out;
      double             now = 0.;
      Progress           progress(out, false, 0., 1., [&now] { return now; });
      now = 1.;
      progress.update(1., 10, 0);
      progress.finish();
      EXPECT_NE(out.str().find("steps/s"), std::string::npos);
      EXPECT_EQ(out.str().find("iterations"), std::string::npos) << out.str();
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


    /// Of what is drawn between "\r\033[K" and the next: the longest.
    std::size_t longest_line(const std::string &text)
    {
      const std::string wipe    = "\r\033[K";
      std::size_t       longest = 0;
      for (std::size_t begin = text.find(wipe); begin != std::string::npos;)
        {
          begin += wipe.size();
          const std::size_t next = text.find(wipe, begin);
          const std::size_t end  = next == std::string::npos ? text.size() - 1 : next; // a newline
          longest                = std::max(longest, end - begin);
          begin                  = next;
        }
      return longest;
    }


    TEST(Progress, TheLineIsNarrowerThanTheTerminal)
    {
      for (const int width : {200, 120, 101, 100, 80, 60, 40, 20})
        EXPECT_LT(longest_line(run(true, width)), std::size_t(width));
      EXPECT_GT(longest_line(run(true, 80)), 60u);
      const std::string usual = run(true, 80);
      EXPECT_NE(usual.find("t = 0.504 of 1 s  left 0:05  100 steps/s"), std::string::npos) << usual;
      EXPECT_NE(run(true, 40).find("[#####......]  50.4 %  t = 0.504 of 1 s\r"), std::string::npos)
        << run(true, 40);
    }


    TEST(Progress, WhatDoesNotFitIsLeftOut)
    {
      EXPECT_EQ(fitting_line({"one", "two", "three"}, ", ", 15), "one, two, three");
      EXPECT_EQ(fitting_line({"one", "two", "three"}, ", ", 14), "one, two");
      EXPECT_EQ(fitting_line({"one", "two", "three"}, ", ", 2), "on");
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
