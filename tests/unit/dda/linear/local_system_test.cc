// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"

#include <hybrid/dda/linear/local_system.h>

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::dense;

  /// Blocks and nodes in two chains, block k beside node k.
  struct Chains
  {
    static constexpr int n = 260;
    BlockMatrix          matrix;
    Eigen::MatrixXd      foundation = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    Eigen::VectorXd      residual   = Eigen::VectorXd::Zero(8 * n), scale;
    LocalSystem          system;

    Chains()
    {
      std::vector<BlockMatrix::Pair> pairs, couplings;
      for (int k = 0; k < n; ++k)
        {
          if (k + 1 < n)
            pairs.push_back({k, k + 1});
          couplings.push_back({k, k});
        }
      matrix.set_pattern(n, n, pairs, couplings);
      for (int k = 0; k < n; ++k)
        {
          matrix.diagonal[k]      = 10. * Mat6::Identity();
          matrix.block_node[k]    = 0.1 * BlockMatrix::Mat62::Random();
          matrix.node_block[k]    = matrix.block_node[k].transpose();
          matrix.node_diagonal[k] = Eigen::Matrix2d::Identity();
        }
      for (std::size_t s = 0; s < matrix.pairs.size(); ++s)
        {
          matrix.off_diagonal[s] = 0.3 * Mat6::Random();
          matrix.lower[s]        = 0.3 * Mat6::Random();
        }
      matrix.symmetric = false;
      for (int i = 0; i < 2 * n; ++i)
        for (int j = 0; j < 2 * n; ++j)
          foundation(i, j) = i == j ? 5. : -std::exp(-std::abs(i - j));
      scale = Eigen::VectorXd::Ones(8 * n);
      for (int k = 0; k < n; ++k)
        scale.segment<4>(6 * k + 2).setConstant(2.);
    }

    bool choose()
    {
      return system.choose(matrix, {residual, scale});
    }
  };
} // namespace



TEST(LocalSystem, has_the_bodies_with_the_residual_and_those_beside_them)
{
  Chains chains;
  chains.residual.setConstant(1e-4);
  chains.residual[6 * 7] = 1.;
  ASSERT_TRUE(chains.choose());
  EXPECT_EQ(chains.system.blocks(), (std::vector<int>{6, 7, 8}));
  EXPECT_EQ(chains.system.nodes(), (std::vector<int>{7}));
  EXPECT_EQ(chains.system.changing_blocks(), (std::vector<int>{5, 6, 7, 8, 9}));
  chains.residual[6 * 7]                      = 1e-4;
  chains.residual[6 * Chains::n + 2 * 20 + 1] = 1.;
  ASSERT_TRUE(chains.choose());
  EXPECT_EQ(chains.system.blocks(), (std::vector<int>{20}));
  EXPECT_EQ(chains.system.nodes(), (std::vector<int>{19, 20, 21}));
  EXPECT_EQ(chains.system.changing_blocks(), (std::vector<int>{19, 20, 21}));
}



TEST(LocalSystem, is_refused_where_the_residual_is_in_many)
{
  Chains chains;
  EXPECT_TRUE(chains.choose()); // nothing is left
  chains.residual.setOnes();
  EXPECT_FALSE(chains.choose());
  // A fifth of the norm may be left to the others, no more.
  chains.residual.setConstant(0.19 / std::sqrt(2. * 8. * Chains::n));
  chains.residual[0] = 1.;
  EXPECT_TRUE(chains.choose());
  chains.residual.setConstant(0.35 / std::sqrt(8. * Chains::n));
  chains.residual[0] = 1.;
  EXPECT_FALSE(chains.choose());
}



TEST(LocalSystem, moves_its_bodies_as_the_dense_part_does_and_no_others)
{
  for (const bool on_foundation : {true, false})
    {
      Chains chains;
      chains.residual[6 * 7 + 1]             = 1.;
      chains.residual[6 * Chains::n + 2 * 8] = 2.;
      ASSERT_TRUE(chains.choose());
      const auto     *foundation = on_foundation ? &chains.foundation : nullptr;
      Eigen::MatrixXd all        = dense(chains.matrix);
      if (on_foundation)
        all.bottomRightCorner(2 * Chains::n, 2 * Chains::n) += chains.foundation;
      std::vector<int> unknowns;
      for (const int b : chains.system.blocks())
        for (int i = 0; i < 6; ++i)
          unknowns.push_back(6 * b + i);
      for (const int k : chains.system.nodes())
        for (int i = 0; i < 2; ++i)
          unknowns.push_back(6 * Chains::n + 2 * k + i);
      const int       size = static_cast<int>(unknowns.size());
      Eigen::MatrixXd part(size, size);
      Eigen::VectorXd b(size);
      for (int i = 0; i < size; ++i)
        {
          b[i] = chains.residual[unknowns[i]];
          for (int j = 0; j < size; ++j)
            part(i, j) = all(unknowns[i], unknowns[j]);
        }
      const Eigen::VectorXd expected = part.lu().solve(b);
      Eigen::VectorXd       x;
      chains.system.solve(chains.matrix, foundation, {chains.residual, chains.scale}, 1e-12, x);
      EXPECT_GT(size, 20);
      for (int i = 0; i < size; ++i)
        {
          EXPECT_NEAR(x[unknowns[i]], expected[i], 1e-10);
          x[unknowns[i]] = 0.;
        }
      EXPECT_EQ(x.norm(), 0.);
    }
}



TEST(LocalSystem, what_it_was_used_for_before_has_no_influence)
{
  Chains          fresh, used;
  Eigen::VectorXd x, y;
  used.residual[6 * 30] = 1.;
  ASSERT_TRUE(used.choose());
  used.matrix = fresh.matrix;
  used.system.solve(used.matrix, &used.foundation, {used.residual, used.scale}, 1e-6, x);
  fresh.residual[6 * 7] = fresh.residual[6 * Chains::n + 14] = 1.;
  used.residual                                              = fresh.residual;
  ASSERT_TRUE(fresh.choose());
  ASSERT_TRUE(used.choose());
  used.system.solve(used.matrix, &used.foundation, {used.residual, used.scale}, 1e-3, x);
  fresh.system.solve(fresh.matrix, &fresh.foundation, {fresh.residual, fresh.scale}, 1e-3, y);
  EXPECT_TRUE(x == y);
}



TEST(LocalSystem, norm_is_that_of_its_bodies)
{
  Chains chains;
  chains.residual[6 * 7 + 2]             = 3.; // over a scale of 2
  chains.residual[6 * Chains::n + 2 * 7] = 2.;
  chains.residual[6 * 20]                = 0.1;
  ASSERT_TRUE(chains.choose());
  EXPECT_DOUBLE_EQ(chains.system.norm({chains.residual, chains.scale}), 2.5);
}
