// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/block_owners.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  /// Centres of columns x rows unit squares, numbered so that neighbours are far apart.
  std::vector<Vec2> grid(const int columns, const int rows)
  {
    const int         n = columns * rows;
    std::vector<Vec2> centres(n);
    for (int k = 0; k < n; ++k)
      centres[k * 7 % n] = Vec2(k % columns, k / columns);
    return centres;
  }

  std::vector<int> counts(const BlockOwners &owners, const int n_blocks, const int n_processes)
  {
    std::vector<int> count(n_processes, 0);
    for (int b = 0; b < n_blocks; ++b)
      ++count[owners.of(b)];
    return count;
  }
} // namespace



TEST(BlockOwners, each_process_has_as_many_blocks)
{
  const std::vector<Vec2> centres = grid(25, 8);
  for (const int n : {1, 2, 3, 4, 7, 16})
    {
      BlockOwners owners;
      owners.cut(centres, n);
      const std::vector<int> count = counts(owners, 200, n);
      const auto [least, most]     = std::minmax_element(count.begin(), count.end());
      EXPECT_LE(*most - *least, 1 + n / 4) << n;
      EXPECT_GE(*least, 200 / n - 2) << n;
    }
}



TEST(BlockOwners, regions_are_cut_across_their_longer_side)
{
  const std::vector<Vec2> centres = grid(25, 8);
  BlockOwners             owners;
  owners.cut(centres, 2);
  for (std::size_t b = 0; b < centres.size(); ++b)
    {
      const int expected = centres[b].x() < 12. ? 0 : 1;
      EXPECT_TRUE(centres[b].x() == 12. || owners.of(static_cast<int>(b)) == expected) << b;
    }
  owners.cut(centres, 8); // three times: x, x, y
  int divided = 0;
  for (std::size_t a = 0; a < centres.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if ((centres[a] - centres[b]).norm() < 1.1)
        divided += owners.of(static_cast<int>(a)) != owners.of(static_cast<int>(b)) ? 1 : 0;
  EXPECT_LE(divided, 3 * 10 + 25 + 3); // of 367 pairs of neighbours
}



TEST(BlockOwners, a_block_that_moves_to_another_region_gets_its_owner)
{
  std::vector<Vec2> centres = grid(10, 2);
  BlockOwners       owners;
  owners.cut(centres, 2);
  const auto leftmost =
    std::min_element(centres.begin(), centres.end(), [](const Vec2 &a, const Vec2 &b) {
      return a.x() < b.x();
    });
  const int b = static_cast<int>(leftmost - centres.begin());
  EXPECT_EQ(owners.of(b), 0);
  centres[b].x() += 20.;
  owners.cut(centres, 2);
  EXPECT_EQ(owners.of(b), 1);
  EXPECT_EQ(counts(owners, 20, 2), (std::vector<int>{10, 10}));
}



TEST(BlockOwners, blocks_at_one_place_and_fewer_blocks_than_processes_are_shared_out_too)
{
  BlockOwners owners;
  owners.cut(std::vector<Vec2>(8, Vec2(1., 2.)), 4);
  EXPECT_EQ(counts(owners, 8, 4), std::vector<int>(4, 2));
  owners.cut(grid(3, 1), 5);
  const std::vector<int> count = counts(owners, 3, 5);
  EXPECT_EQ(*std::max_element(count.begin(), count.end()), 1);
}
