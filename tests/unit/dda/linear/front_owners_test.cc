// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_fronts.h"

#include <hybrid/dda/linear/front_owners.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::grid_fronts;

  std::vector<double> loads(const FrontTree &tree, const FrontOwners &owners, double &of_all)
  {
    std::vector<double> load(owners.processes, 0.);
    of_all = 0.;
    for (int f = 0; f < tree.n_fronts(); ++f)
      (owners.of[f] == FrontOwners::all ? of_all : load[owners.of[f]]) += tree.products_of(f);
    return load;
  }
} // namespace



TEST(FrontOwners, subtrees_go_to_one_process_and_what_is_above_to_all)
{
  const FrontTree tree = grid_fronts(60, 50);
  for (const int n : {2, 3, 4, 7})
    {
      const FrontOwners owners(tree, n);
      ASSERT_EQ(owners.of.size(), static_cast<std::size_t>(tree.n_fronts()));
      for (int f = 0; f < tree.n_fronts(); ++f)
        {
          EXPECT_GE(owners.of[f], FrontOwners::all);
          EXPECT_LT(owners.of[f], n);
          const int parent = tree.parent[f];
          if (parent < 0)
            continue;
          EXPECT_TRUE(owners.of[parent] == FrontOwners::all || owners.of[parent] == owners.of[f]);
          EXPECT_EQ(owners.is_handed_over(tree, f),
                    owners.of[f] != FrontOwners::all && owners.of[parent] == FrontOwners::all);
        }
    }
}



TEST(FrontOwners, the_process_with_most_has_less_than_one_alone)
{
  const FrontTree tree = grid_fronts(100, 100);
  double          last = tree.products;
  for (const int n : {2, 4})
    {
      const FrontOwners         owners(tree, n);
      double                    of_all = 0.;
      const std::vector<double> load   = loads(tree, owners, of_all);
      const double              most   = *std::max_element(load.begin(), load.end());
      EXPECT_NEAR(owners.largest, of_all + most, 1e-9 * tree.products);
      EXPECT_LT(owners.largest, 0.8 * last); // 0.65 and 0.48 of all: the top stays with everyone
      EXPECT_GT(*std::min_element(load.begin(), load.end()), 0.3 * most);
      last = owners.largest;
    }
}



TEST(FrontOwners, pieces_apart_need_no_top)
{
  std::vector<BlockMatrix::Pair> pairs;
  for (int b = 0; b < 400; b += 4)
    pairs.push_back({b, b + 1});
  const FrontTree   tree(400, pairs);
  const FrontOwners owners(tree, 4);
  EXPECT_EQ(std::count(owners.of.begin(), owners.of.end(), FrontOwners::all), 0);
  EXPECT_LT(owners.largest, 0.3 * tree.products);
}



TEST(FrontOwners, one_process_has_all)
{
  const FrontTree   tree = grid_fronts(5, 4);
  const FrontOwners owners(tree, 1);
  EXPECT_EQ(std::count(owners.of.begin(), owners.of.end(), 0), tree.n_fronts());
  EXPECT_EQ(owners.largest, tree.products);
}
