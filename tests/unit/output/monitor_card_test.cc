// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/output/monitor_card.h>

#include <gtest/gtest.h>

using namespace hybrid;

namespace
{
  dda::Model two_blocks()
  {
    return dda::build_model(test::square_blocks(2, 1, 2.),
                            test::block_parameters(30.),
                            test::straight_foundation(0., 1., 5., 7));
  }

  scene::Monitor monitor(const std::string &name)
  {
    scene::Monitor m;
    m.name = name;
    return m;
  }
} // namespace



TEST(MonitorCard, tells_what_each_follows)
{
  const dda::Model model = two_blocks();
  EXPECT_EQ(output::describe_monitors({monitor("top"), monitor("base"), monitor("foot")},
                                      {1, -1, 0},
                                      model),
            "Monitors   of the mass: top, foot; of the ground: base");
  EXPECT_EQ(output::describe_monitors({monitor("slab")}, {-1}, model),
            "Monitors   of the ground: slab");
  EXPECT_EQ(output::describe_monitors({monitor("slab")}, {0}, model),
            "Monitors   of the mass: slab");
  EXPECT_EQ(output::describe_monitors({}, {}, model), "");
}



TEST(MonitorCard, shortens_long_lists)
{
  std::vector<scene::Monitor> monitors;
  for (int k = 1; k <= 15; ++k)
    monitors.push_back(monitor("S" + std::to_string(k)));
  EXPECT_EQ(output::describe_monitors(monitors, std::vector<int>(15, 0), two_blocks()),
            "Monitors   of the mass: S1, S2, S3, S4, S5, S6, S7, S8, S9, S10, S11, S12 and 3 more");
}
