// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/blocks_at_work.h>

#include <gtest/gtest.h>

using hybrid::dda::BlocksAtWork;

TEST(BlocksAtWork, a_few_are_at_work_until_all_are_again)
{
  BlocksAtWork blocks;
  blocks.begin(4);
  EXPECT_EQ(blocks.at_work(), (std::vector<int>{0, 1, 2, 3}));
  blocks.narrow({1, 3});
  EXPECT_EQ(blocks.at_work(), (std::vector<int>{1, 3}));
  for (int b = 0; b < 4; ++b)
    EXPECT_EQ(blocks.is_held(b), b % 2 == 0) << b;
  blocks.widen();
  EXPECT_EQ(blocks.at_work().size(), 4u);
  for (int b = 0; b < 4; ++b)
    EXPECT_FALSE(blocks.is_held(b)) << b;
}
