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



TEST(BlockMatrix, a_part_has_the_rows_and_columns_of_its_blocks_and_nodes)
{
  const BlockMatrix      whole = unsymmetric_block_matrix(12, 7, 0.1);
  const std::vector<int> blocks{1, 2, 5, 11}, nodes{2, 3, 6};
  BlockMatrix            part;
  part.set_part(whole, blocks, nodes);
  std::vector<int> unknowns;
  for (const int b : blocks)
    for (int i = 0; i < 6; ++i)
      unknowns.push_back(6 * b + i);
  for (const int k : nodes)
    for (int i = 0; i < 2; ++i)
      unknowns.push_back(6 * 12 + 2 * k + i);
  const Eigen::MatrixXd all = dense(whole), found = dense(part);
  ASSERT_EQ(found.rows(), static_cast<int>(unknowns.size()));
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      EXPECT_EQ(found(i, j), all(unknowns[i], unknowns[j]));
  EXPECT_EQ(part.symmetric, whole.symmetric);
}



TEST(BlockMatrix, knows_what_is_coupled_to_a_block_and_to_a_node)
{
  BlockMatrix m;
  m.set_pattern(4, 3, {{2, 1}, {0, 3}, {3, 2}}, {{3, 0}, {3, 2}, {1, 2}});
  const auto at_block = m.blocks_at_block(2);
  EXPECT_EQ(std::vector<int>(at_block.begin(), at_block.end()), (std::vector<int>{1, 3}));
  const auto [first, last] = m.couplings_of_block(3);
  ASSERT_EQ(last - first, 2);
  EXPECT_EQ(m.couplings[first], (BlockMatrix::Pair{3, 0}));
  std::vector<int> blocks;
  for (const int s : m.couplings_of_node(2))
    blocks.push_back(m.couplings[s][0]);
  EXPECT_EQ(blocks, (std::vector<int>{1, 3}));
}
