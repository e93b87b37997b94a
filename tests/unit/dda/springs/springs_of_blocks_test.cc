// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/model.h>
#include <hybrid/dda/springs/springs_of_blocks.h>

#include <gtest/gtest.h>

using namespace hybrid::dda;

TEST(SpringsOfBlocks, each_spring_is_listed_with_both_its_blocks_or_the_foundation)
{
  SpringsOfBlocks lists;
  lists.sort({{2, 0, {0, 0}}, {1, foundation_body, {3, 4}}, {0, 2, {0, 0}}, {2, 0, {0, 0}}}, 4);
  const auto of = [&](const int block) {
    const auto [first, last] = lists.of_block(block);
    return std::vector<int>(first, last);
  };
  EXPECT_EQ(lists.n_blocks(), 4);
  EXPECT_EQ(of(0), (std::vector<int>{1, 4, 7}));
  EXPECT_EQ(of(1), (std::vector<int>{2}));
  EXPECT_EQ(of(2), (std::vector<int>{0, 5, 6}));
  EXPECT_TRUE(lists.of_block(3).empty());
  EXPECT_EQ(lists.on_foundation(), std::vector<int>{1});
  EXPECT_EQ(lists.version(), 1);
  lists.sort({}, 4);
  EXPECT_TRUE(lists.of_block(0).empty() && lists.on_foundation().empty());
  EXPECT_EQ(lists.version(), 2);
}
