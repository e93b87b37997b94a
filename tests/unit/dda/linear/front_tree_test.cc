// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/front_tree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{
  using hybrid::dda::FrontTree;
  using Pairs = std::vector<hybrid::dda::BlockMatrix::Pair>;

  /// Neighbours in a square of n by n blocks.
  Pairs square(const int n)
  {
    Pairs pairs;
    for (int b = 0; b < n * n; ++b)
      {
        if ((b + 1) % n != 0)
          pairs.push_back({b, b + 1});
        if (b + n < n * n)
          pairs.push_back({b, b + n});
      }
    return pairs;
  }

  /// Place of the block at a position of a front.
  int place_at(const FrontTree &tree, const int f, const int position)
  {
    return position < tree.own(f) ? tree.begin[f] + position
                                  : tree.later_places[tree.later_begin[f] + position - tree.own(f)];
  }
} // namespace



TEST(FrontTree, every_block_is_eliminated_once)
{
  const FrontTree  tree(400, square(20));
  std::vector<int> sorted = tree.block, all(400);
  std::sort(sorted.begin(), sorted.end());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
  for (int b = 0; b < 400; ++b)
    EXPECT_EQ(tree.block[tree.place[b]], b);
}



TEST(FrontTree, a_front_holds_what_its_blocks_are_coupled_to_and_goes_to_its_parent)
{
  const Pairs     pairs = square(20);
  const FrontTree tree(400, pairs);
  for (const auto &pair : pairs)
    {
      const int first = std::min(tree.place[pair[0]], tree.place[pair[1]]),
                last = std::max(tree.place[pair[0]], tree.place[pair[1]]), f = tree.front[first];
      EXPECT_EQ(place_at(tree, f, tree.position(f, first)), first);
      EXPECT_EQ(place_at(tree, f, tree.position(f, last)), last);
    }
  for (int f = 0; f < tree.n_fronts(); ++f)
    {
      EXPECT_EQ(tree.parent[f] < 0, tree.later(f) == 0);
      if (tree.parent[f] >= 0)
        {
          EXPECT_GT(tree.parent[f], f);
        }
      for (int k = tree.later_begin[f]; k < tree.later_begin[f + 1]; ++k)
        EXPECT_EQ(place_at(tree, tree.parent[f], tree.in_parent[k]), tree.later_places[k]);
    }
}



TEST(FrontTree, a_chain_fills_nothing_in)
{
  Pairs chain;
  for (int b = 0; b + 1 < 100; ++b)
    chain.push_back({b, b + 1});
  EXPECT_LE(FrontTree(100, chain).entries, 4. * 100.);
}



// Nested dissection of a square: entries grow as n log n, products as n^(3/2) (George
// 1973), with less beside.
TEST(FrontTree, factors_of_a_square_grow_as_nested_dissection_says)
{
  const FrontTree small(2500, square(50)), large(40000, square(200));
  EXPECT_LT(large.entries / small.entries, 32.);    // n log n: 22, n^2: 256
  EXPECT_LT(large.products / small.products, 100.); // n^(3/2): 64, n^2: 256
}



TEST(FrontTree, nothing_is_no_front)
{
  EXPECT_EQ(FrontTree(0, {}).n_fronts(), 0);
  EXPECT_EQ(FrontTree(3, {}).n_blocks(), 3);
}
