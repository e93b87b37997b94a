// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_fronts.h"

#include <hybrid/dda/linear/front_plan.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
  using hybrid::dda::FrontPlan;
  using hybrid::dda::FrontTree;
  using hybrid::test::grid_fronts;
} // namespace



TEST(FrontPlan, every_front_comes_once_and_subtrees_are_independent)
{
  const FrontTree  tree = grid_fronts(50, 50);
  const FrontPlan  plan(tree, true);
  std::vector<int> part(tree.n_fronts(), -2);
  ASSERT_GT(plan.shared.size(), 8U);
  for (std::size_t s = 0; s < plan.shared.size(); ++s)
    for (int f = plan.shared[s].first; f < plan.shared[s].last; ++f)
      {
        EXPECT_EQ(part[f], -2);
        part[f] = static_cast<int>(s);
      }
  for (const int f : plan.above)
    {
      EXPECT_EQ(part[f], -2);
      part[f] = -1;
    }
  EXPECT_EQ(std::count(part.begin(), part.end(), -2), 0);
  for (int f = 0; f < tree.n_fronts(); ++f)
    for (int c = plan.child_begin[f]; c < plan.child_begin[f + 1]; ++c)
      {
        EXPECT_EQ(tree.parent[plan.child[c]], f);
        EXPECT_TRUE(part[f] == -1 || part[plan.child[c]] == part[f]);
      }
}



TEST(FrontPlan, subtrees_are_small_and_hold_most_fronts)
{
  const FrontTree tree = grid_fronts(50, 50);
  const FrontPlan plan(tree, true);
  for (const FrontPlan::Subtrees &trees : plan.shared)
    {
      double products = 0.;
      for (int f = trees.first; f < trees.last; ++f)
        products += tree.products_of(f);
      EXPECT_LE(products, tree.products / 16.);
    }
  EXPECT_LT(10 * plan.above.size(), static_cast<std::size_t>(tree.n_fronts()));
}



// What a front leaves stays untouched until its parent has taken it, in whatever order the subtrees
// are eliminated; in turn it takes less memory.
TEST(FrontPlan, what_waits_is_not_overwritten)
{
  const FrontTree tree = grid_fronts(30, 30);
  std::size_t     size[2];
  for (const bool is_shared : {false, true})
    {
      const FrontPlan plan(tree, is_shared);
      const auto      end = [&](const int f) {
        return plan.place[f] + 36 * static_cast<std::size_t>(tree.later(f)) * tree.later(f);
      };
      std::vector<int> owner(plan.size, -1);
      const auto       eliminate = [&](const int f) {
        ASSERT_LE(end(f), plan.size);
        for (std::size_t k = plan.place[f]; k < end(f); ++k)
          {
            ASSERT_TRUE(owner[k] < 0) << "front " << f << " overwrites " << owner[k];
            owner[k] = f;
          }
        for (int c = plan.child_begin[f]; c < plan.child_begin[f + 1]; ++c)
          for (std::size_t k = plan.place[plan.child[c]]; k < end(plan.child[c]); ++k)
            {
              ASSERT_EQ(owner[k], plan.child[c]);
              owner[k] = -1;
            }
      };
      for (auto trees = plan.shared.rbegin(); trees != plan.shared.rend(); ++trees)
        for (int f = trees->first; f < trees->last; ++f)
          eliminate(f);
      for (const int f : plan.above)
        eliminate(f);
      EXPECT_EQ(plan.shared.empty(), !is_shared);
      size[is_shared ? 1 : 0] = plan.size;
    }
  EXPECT_LT(2 * size[0], size[1]);
}



TEST(FrontPlan, all_that_is_kept_has_a_place_of_its_own)
{
  const FrontTree tree = grid_fronts(30, 30);
  FrontPlan       plan(tree, true);
  const auto      stacked = plan.size;
  plan.keep_all(tree);
  EXPECT_GT(plan.size, stacked);
  EXPECT_EQ(plan.size, FrontPlan::left_by_all(tree));
  std::size_t next = 0;
  for (int f = 0; f < tree.n_fronts(); ++f)
    {
      EXPECT_EQ(plan.place[f], next);
      next += 36 * static_cast<std::size_t>(tree.later(f)) * tree.later(f);
    }
}
