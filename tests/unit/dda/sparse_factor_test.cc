// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"

#include <hybrid/dda/sparse_factor.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::dense;
  using hybrid::test::random_block_matrix;
  using hybrid::test::unsymmetric_block_matrix;
} // namespace



TEST(SparseFactor, solves_the_blocks_part)
{
  const BlockMatrix m = random_block_matrix(25, 0);
  SparseFactor      factor;
  EXPECT_FALSE(factor.ready(25));
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_TRUE(factor.ready(25));
  EXPECT_FALSE(factor.ready(24));
  const Eigen::VectorXd b = Eigen::VectorXd::Random(150);
  Eigen::VectorXd       x(150);
  factor.solve(b, x);
  EXPECT_LT((dense(m) * x - b).norm(), 1e-12 * b.norm());
}



TEST(SparseFactor, solves_an_unsymmetric_blocks_part)
{
  const BlockMatrix m = unsymmetric_block_matrix(25, 0, 0.1);
  SparseFactor      factor;
  ASSERT_TRUE(factor.factorize(m));
  const Eigen::VectorXd b = Eigen::VectorXd::Random(150);
  Eigen::VectorXd       x(150);
  factor.solve(b, x);
  EXPECT_LT((dense(m) * x - b).norm(), 1e-12 * b.norm());
}



TEST(SparseFactor, new_values_in_the_same_pattern)
{
  BlockMatrix  m = random_block_matrix(25, 0);
  SparseFactor factor;
  ASSERT_TRUE(factor.factorize(m));
  for (Mat6 &block : m.diagonal)
    block *= 2.;
  ASSERT_TRUE(factor.factorize(m));
  const Eigen::VectorXd b = Eigen::VectorXd::Random(150);
  Eigen::VectorXd       x(150);
  factor.solve(b, x);
  EXPECT_LT((dense(m) * x - b).norm(), 1e-12 * b.norm());
}
