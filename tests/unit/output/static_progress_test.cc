// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/static_progress.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hybrid::output
{
  namespace
  {
    /// So many iterations of 0.1 s, ten to a step; the residual falls by ten in each.
    std::string stage(const bool is_terminal, const int iterations, const int width = 120)
    {
      std::ostringstream out;
      double             now = 50.;
      StaticProgressLine line(
        out, is_terminal, [&now] { return now; }, [width] { return width; });
      for (int i = 1; i <= iterations; ++i)
        {
          now += 0.1;
          line.update({i / 10, i, std::pow(10., -(i / 10)), 1e-9});
        }
      return out.str();
    }


    TEST(StaticProgressLine, TerminalLineIsRedrawnInPlace)
    {
      EXPECT_EQ(stage(true, 4), ""); // a short stage
      const std::string text = stage(true, 50);
      EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0);
      EXPECT_GE(std::count(text.begin(), text.end(), '\r'), 15);
      EXPECT_NE(text.find("\r\033[KStatic stage: 4 steps, 45 iterations, relative residual 1.0e-04 "
                          "(ends at 1e-09)"),
                std::string::npos)
        << text;
    }


    TEST(StaticProgressLine, TheLineIsNarrowerThanTheTerminal)
    {
      for (const int width : {120, 80, 60, 20})
        {
          std::istringstream lines(stage(true, 50, width));
          for (std::string line; std::getline(lines, line, '\r');)
            EXPECT_LT(line.size(), width + std::string("\033[K").size()) << line;
        }
      EXPECT_NE(
        stage(true, 50, 70).find("Static stage: 4 steps, 45 iterations, residual 1.0e-04 of 1e-09"),
        std::string::npos);
    }


    TEST(StaticProgressLine, PlainLinesAreSparse)
    {
      EXPECT_EQ(stage(false, 590), "");
      const std::string text = stage(false, 1300);
      EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
      EXPECT_EQ(text.find('\r'), std::string::npos);
    }
  } // namespace
} // namespace hybrid::output
