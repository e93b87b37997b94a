// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"

#include <hybrid/dda/linear/sparse_factor.h>
#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::dense;
  using hybrid::test::random_block_matrix;
  using hybrid::test::unsymmetric_block_matrix;

  /// Few blocks touch: BlockLu. And many, beyond what it is for: FrontalLu.
  const std::vector<int> few{1, 3}, many{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};

  /// x of a fixed right-hand side.
  Eigen::VectorXd solution(SparseFactor &factor)
  {
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(150, -1., 2.);
    Eigen::VectorXd       x(150);
    factor.solve(b, x);
    return x;
  }

  /// Store @p factor beside @p matrix and read both into others.
  void restore(SparseFactor &factor, BlockMatrix &matrix, SparseFactor &copy, BlockMatrix &other)
  {
    using hybrid::restart::Archive;
    Archive writer = Archive::writer();
    writer(matrix);
    factor.serialize(writer);
    Archive reader = Archive::reader(writer.content());
    reader(other);
    copy.serialize(reader);
    EXPECT_TRUE(reader.at_end());
  }
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
  for (const auto &distances : {few, many})
    {
      const BlockMatrix m = unsymmetric_block_matrix(25, 0, 0.1, distances);
      SparseFactor      factor;
      ASSERT_TRUE(factor.factorize(m));
      EXPECT_EQ(factor.is_block_lu(), distances == few);
      const Eigen::VectorXd b = Eigen::VectorXd::Random(150);
      Eigen::VectorXd       x(150);
      factor.solve(b, x);
      EXPECT_LT((dense(m) * x - b).norm(), 1e-12 * b.norm());
    }
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



TEST(SparseFactor, a_restored_factor_gives_the_same_bits)
{
  for (BlockMatrix m : {random_block_matrix(25, 0),
                        unsymmetric_block_matrix(25, 0, 0.1, few),
                        unsymmetric_block_matrix(25, 0, 0.1, many)})
    {
      SparseFactor factor, copy;
      BlockMatrix  other;
      ASSERT_TRUE(factor.factorize(m));
      for (Mat6 &block : m.diagonal)
        block *= 1.1; // the factor is that of an earlier matrix
      restore(factor, m, copy, other);
      ASSERT_TRUE(copy.ready(25));
      EXPECT_EQ(solution(copy), solution(factor));
    }
}



// The order depends on what was factored before: it has to survive.
TEST(SparseFactor, later_factors_of_a_restored_one_give_the_same_bits)
{
  BlockMatrix m         = unsymmetric_block_matrix(25, 0, 0.1, many),
              symmetric = random_block_matrix(25, 0, many);
  SparseFactor factor, copy;
  BlockMatrix  other;
  ASSERT_TRUE(factor.factorize(m));
  for (int i = 0; i < 25; ++i)
    m.diagonal[i] = symmetric.diagonal[i];
  m.lower     = symmetric.lower;
  m.symmetric = true;
  ASSERT_TRUE(factor.factorize(m)); // a symmetric one now
  restore(factor, m, copy, other);
  EXPECT_EQ(solution(copy), solution(factor));
  for (BlockMatrix *matrix : {&m, &other})
    {
      matrix->diagonal[3](0, 1) += 0.3;
      matrix->symmetric = false;
    }
  ASSERT_TRUE(factor.factorize(m) && copy.factorize(other));
  EXPECT_EQ(solution(copy), solution(factor));
}



TEST(SparseFactor, no_factor_is_restored_as_none)
{
  BlockMatrix  m = random_block_matrix(25, 0), other;
  SparseFactor factor, copy;
  restore(factor, m, copy, other);
  EXPECT_FALSE(copy.ready(25));
}
