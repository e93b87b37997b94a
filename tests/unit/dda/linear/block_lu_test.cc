// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"

#include <hybrid/dda/linear/block_lu.h>
#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::dense;
  using hybrid::test::unsymmetric_block_matrix;

  /// Relative residual of a solution.
  double error(const BlockLu &factor, const BlockMatrix &m)
  {
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(6 * m.n_blocks(), -1., 2.);
    Eigen::VectorXd       x(b.size());
    factor.solve(b, x);
    return (dense(m) * x - b).norm() / b.norm();
  }

  /// No spring between the blocks of every pair but each @p step -th.
  void part_pairs(BlockMatrix &m, const std::size_t step)
  {
    for (std::size_t s = 0; s < m.pairs.size(); ++s)
      if (s % step != 0)
        {
          m.off_diagonal[s].setZero();
          m.lower[s].setZero();
        }
  }
} // namespace



TEST(BlockLu, solves)
{
  const BlockMatrix m = unsymmetric_block_matrix(40, 0, 0.1, {1, 3, 7});
  BlockLu           factor;
  factor.analyze(m);
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_LT(error(factor, m), 1e-12);
}



TEST(BlockLu, a_chain_fills_nothing_in)
{
  const BlockMatrix m = unsymmetric_block_matrix(40, 0, 0.1, {1});
  BlockLu           factor;
  EXPECT_EQ(factor.analyze(m), 2 * 39); // each block but the last has one neighbour left
}



TEST(BlockLu, no_order_is_found_that_takes_more_than_allowed)
{
  const BlockMatrix m = unsymmetric_block_matrix(40, 0, 0.1, {1, 3, 7});
  const long        n = BlockLu().analyze(m);
  BlockLu           factor;
  EXPECT_EQ(factor.analyze(m, n), n);
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_LT(error(factor, m), 1e-12);
  EXPECT_GT(factor.analyze(m, n - 1), n - 1);
  EXPECT_EQ(factor.analyze(m, n), n);
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_LT(error(factor, m), 1e-12);
}



TEST(BlockLu, the_order_follows_the_pairs_that_touch)
{
  BlockMatrix m = unsymmetric_block_matrix(40, 0, 0.1, {1, 3, 7}), few = m;
  part_pairs(few, 3);
  BlockLu    factor;
  const long all = factor.analyze(m), less = factor.analyze(few);
  EXPECT_LT(less, all);
  for (int round = 0; round < 2; ++round) // the second time from memory
    {
      EXPECT_EQ(factor.analyze(few), less);
      ASSERT_TRUE(factor.factorize(few));
      EXPECT_LT(error(factor, few), 1e-12);
    }
  EXPECT_EQ(factor.analyze(m), all);
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_LT(error(factor, m), 1e-12);
}



TEST(BlockLu, a_star_is_eliminated_from_its_ends)
{
  BlockMatrix                    m;
  std::vector<BlockMatrix::Pair> pairs;
  for (int i = 1; i < 20; ++i)
    pairs.push_back({0, i});
  m.set_pattern(20, 0, pairs, {});
  for (Mat6 &block : m.off_diagonal)
    block.setOnes();
  EXPECT_EQ(BlockLu().analyze(m), 2 * 19);
}



TEST(BlockLu, pairs_that_do_not_touch_cost_nothing)
{
  BlockMatrix m = unsymmetric_block_matrix(40, 0, 0.1, {1, 2, 3, 4, 5, 6});
  BlockLu     factor;
  const long  all = factor.analyze(m);
  part_pairs(m, 6); // a chain is left
  EXPECT_LT(10 * factor.analyze(m), all);
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_LT(error(factor, m), 1e-12);
  part_pairs(m, m.pairs.size() + 1); // and nothing but its first pair
  EXPECT_LE(factor.analyze(m), 2);
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_LT(error(factor, m), 1e-12);
}



TEST(BlockLu, a_singular_block_and_growing_entries_are_noticed)
{
  BlockMatrix m = unsymmetric_block_matrix(10, 0, 0.1, {1});
  BlockLu     factor;
  m.diagonal[4].setZero();
  part_pairs(m, m.pairs.size() + 1);
  factor.analyze(m);
  EXPECT_FALSE(factor.factorize(m));

  BlockMatrix tiny = unsymmetric_block_matrix(2, 0, 0.1, {1});
  tiny.diagonal[0] = tiny.diagonal[1] = 1e-8 * Mat6::Identity(); // regular, but only with exchanges
  factor.analyze(tiny);
  EXPECT_FALSE(factor.factorize(tiny));
}



TEST(BlockLu, a_restored_factor_gives_the_same_bits)
{
  using hybrid::restart::Archive;
  const BlockMatrix m = unsymmetric_block_matrix(40, 0, 0.1, {1, 3});
  BlockLu           factor, copy;
  factor.analyze(m);
  ASSERT_TRUE(factor.factorize(m));
  Archive writer = Archive::writer();
  writer(factor);
  Archive reader = Archive::reader(writer.content());
  reader(copy);
  EXPECT_TRUE(reader.at_end());
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(240, -1., 2.);
  Eigen::VectorXd       x(240), y(240);
  factor.solve(b, x);
  copy.solve(b, y);
  EXPECT_EQ(x, y);
}
