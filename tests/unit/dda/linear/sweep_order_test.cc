// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/sweep_order.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
  using namespace hybrid::dda;
  using hybrid::Vec2;
  using Pairs = std::vector<std::array<int, 2>>;
} // namespace



TEST(SweepOrder, one_part_keeps_the_order_of_the_numbers)
{
  const SweepOrder order(4, {}, {{0, 3}, {1, 2}});
  EXPECT_EQ(order.n_parts(), 1);
  EXPECT_EQ(order.block, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(order.begin, (std::vector<int>{0, 4, 4}));
}



TEST(SweepOrder, blocks_that_couple_two_parts_come_last)
{
  // A chain 0 - 1 - 2 - 3 - 4 - 5, cut in the middle: block 3 couples to the part before its own.
  const SweepOrder order(6, {0, 0, 0, 1, 1, 1}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
  EXPECT_EQ(order.n_parts(), 2);
  EXPECT_EQ(order.block, (std::vector<int>{0, 1, 2, 4, 5, 3}));
  EXPECT_EQ(order.begin, (std::vector<int>{0, 3, 5, 6}));
  for (int b = 0; b < 6; ++b)
    EXPECT_EQ(order.block[order.place[b]], b);
}



TEST(SweepOrder, no_pair_joins_two_parts)
{
  constexpr int n = 200;
  Pairs         pairs;
  std::srand(3);
  std::vector<int> part(n);
  for (int &p : part)
    p = std::rand() % 5;
  for (int k = 0; k < 300; ++k)
    pairs.push_back({std::rand() % n, std::rand() % n});
  const SweepOrder order(n, part, pairs);
  const auto       part_of = [&](const int block) {
    return std::upper_bound(order.begin.begin(), order.begin.end(), order.place[block]) -
           order.begin.begin();
  };
  const int separator = order.n_parts() + 1;
  for (const auto &[i, j] : pairs)
    EXPECT_TRUE(part_of(i) == part_of(j) || part_of(i) == separator || part_of(j) == separator);
  EXPECT_GT(order.begin[order.n_parts()], 0);
}



TEST(SweepOrder, slices_are_equal_and_across_the_longer_side)
{
  std::vector<Vec2> centres;
  for (int k = 0; k < 512; ++k)
    centres.push_back({k % 2, (511 - k) * 1.});
  const std::vector<int> part = slices(centres);
  for (int k = 0; k < 512; ++k)
    EXPECT_EQ(part[k], (511 - k) / 128);
}



TEST(SweepOrder, few_blocks_are_one_slice)
{
  EXPECT_EQ(slices({{0., 0.}, {1., 0.}, {5., 0.}}), (std::vector<int>{0, 0, 0}));
  EXPECT_TRUE(slices({}).empty());
}
