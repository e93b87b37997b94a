// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/heartbeat.h>

#include <gtest/gtest.h>

#include <chrono>
#include <sstream>

namespace hybrid::output
{
  namespace
  {
    std::string work(const bool is_terminal, const double seconds, const double interval)
    {
      std::ostringstream out;
      {
        const Heartbeat heartbeat(out, is_terminal, "Meshing about 90000 cells", interval);
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
      }
      return out.str();
    }


    TEST(Heartbeat, TellsThatLongWorkGoesOn)
    {
      const std::string text = work(true, 0.2, 0.01);
      EXPECT_EQ(text.rfind("\r\033[KMeshing about 90000 cells: 0:00\r", 0), 0u) << text;
      EXPECT_EQ(text.substr(text.size() - 4), "\r\033[K"); // wiped
      EXPECT_EQ(work(false, 0.2, 0.01).rfind("Meshing about 90000 cells: 0:00\n", 0), 0u);
    }


    TEST(Heartbeat, IsSilentDuringShortWork)
    {
      EXPECT_EQ(work(true, 0., 0.), "");
      EXPECT_EQ(work(false, 0., 0.), "");
    }
  } // namespace
} // namespace hybrid::output
