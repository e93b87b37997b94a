// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"

#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>
#include <omp.h>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::dense;
  using hybrid::test::random_block_matrix;
  using hybrid::test::unsymmetric_block_matrix;
} // namespace



TEST(BlockMatrix, pairs_are_found_in_either_way_of_giving_them)
{
  BlockMatrix m;
  m.set_pattern(4, 3, {{2, 1}, {1, 2}, {0, 3}}, {{3, 0}, {3, 2}, {3, 0}});
  EXPECT_EQ(m.pairs.size(), 2u);
  EXPECT_EQ(m.block_slot(1, 2), 1);
  EXPECT_EQ(m.block_slot(0, 3), 0);
  EXPECT_EQ(m.block_slot(0, 1), -1);
  EXPECT_EQ(m.node_slot(3, 2), 1);
  EXPECT_EQ(m.node_slot(3, 1), -1);
  EXPECT_EQ(m.size(), 30);
}



TEST(BlockMatrix, every_new_pattern_has_a_new_version)
{
  BlockMatrix m;
  m.set_pattern(2, 0, {{0, 1}}, {});
  const int version = m.pattern_version();
  m.set_zero();
  EXPECT_EQ(m.pattern_version(), version);
  m.set_pattern(2, 0, {{0, 1}}, {});
  EXPECT_NE(m.pattern_version(), version);
}



TEST(BlockMatrix, multiplies_as_the_dense_matrix)
{
  for (const BlockMatrix &m : {random_block_matrix(12, 7), unsymmetric_block_matrix(12, 7, 0.1)})
    {
      const Eigen::VectorXd x = Eigen::VectorXd::Random(m.size());
      Eigen::VectorXd       y(m.size());
      m.multiply(x, y);
      EXPECT_LT((y - dense(m) * x).norm(), 1e-13 * y.norm());
    }
}



TEST(BlockMatrix, any_number_of_threads_gives_the_same_bits)
{
  const BlockMatrix     m = random_block_matrix(2100, 9);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(m.size());
  Eigen::VectorXd       one(m.size()), two(m.size());
  const int             threads = omp_get_max_threads();
  omp_set_num_threads(1);
  m.multiply(x, one);
  omp_set_num_threads(2);
  m.multiply(x, two);
  omp_set_num_threads(threads);
  EXPECT_TRUE(one == two);
}



TEST(BlockMatrix, a_restored_matrix_is_the_same)
{
  using hybrid::restart::Archive;
  hybrid::dda::BlockMatrix m      = hybrid::test::unsymmetric_block_matrix(12, 5, 0.2), copy;
  Archive                  writer = Archive::writer();
  writer(m);
  Archive reader = Archive::reader(writer.content());
  reader(copy);
  EXPECT_TRUE(reader.at_end());
  EXPECT_EQ(hybrid::test::dense(copy), hybrid::test::dense(m));
  EXPECT_FALSE(copy.symmetric);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(m.size(), -1., 1.);
  Eigen::VectorXd       y(m.size()), z(m.size());
  m.multiply(x, y);
  copy.multiply(x, z);
  EXPECT_EQ(y, z);
}
