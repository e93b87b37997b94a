// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/held_nodes.h>

namespace
{
  using hybrid::continuum::HeldNodes;
}



TEST(HeldNodes, a_single_rank_holds_all_at_their_numbers)
{
  HeldNodes held(7);
  held.add({3, 5});
  EXPECT_EQ(held.size(), 7u);
  EXPECT_TRUE(held.others().empty());
  for (int node = 0; node < 7; ++node)
    EXPECT_EQ(held.slot(node), node);
}



TEST(HeldNodes, own_nodes_stand_first_and_others_behind_them)
{
  HeldNodes held(std::vector<int>{2, 4, 9});
  held.add({7, 4, 1, 7});
  EXPECT_EQ(held.size(), 5u);
  EXPECT_EQ(held.others(), (std::vector<int>{1, 7}));
  EXPECT_EQ(held.slots({2, 4, 9, 1, 7}), (std::vector<int>{0, 1, 2, 3, 4}));
  for (const int node : {0, 3, 5, 8, 10})
    EXPECT_EQ(held.slot(node), -1) << node;
}



TEST(HeldNodes, slots_stay_as_further_nodes_are_added)
{
  HeldNodes held(std::vector<int>{2, 4, 9});
  held.add({7});
  held.add({0, 7, 2});
  EXPECT_EQ(held.others(), (std::vector<int>{7, 0}));
  EXPECT_EQ(held.slots({9, 7, 0}), (std::vector<int>{2, 3, 4}));
}



TEST(HeldNodes, a_rank_without_own_nodes_holds_what_it_is_told)
{
  HeldNodes held(std::vector<int>{});
  EXPECT_EQ(held.slot(0), -1);
  held.add({5});
  EXPECT_EQ(held.size(), 1u);
  EXPECT_EQ(held.slot(5), 0);
}
