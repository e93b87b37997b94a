// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"

#include <hybrid/dda/linear/joined_matrix.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::dense;
  using hybrid::test::unsymmetric_block_matrix;

  constexpr int n_blocks = 9;

  /// Stiffness whose entries fall tenfold with each unknown of distance.
  Eigen::MatrixXd falling_stiffness(const int n)
  {
    Eigen::MatrixXd s(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        s(i, j) = 3. * std::pow(0.1, std::abs(i - j));
    return s;
  }

  /// What the joined matrix should be but for the tails of S.
  Eigen::MatrixXd expected(const BlockMatrix &m, const Eigen::MatrixXd &s)
  {
    Eigen::MatrixXd full = dense(m);
    full.bottomRightCorner(s.rows(), s.cols()) += s;
    return full;
  }
} // namespace



TEST(JoinedMatrix, is_blocks_and_foundation_but_for_the_tails_of_the_foundation)
{
  for (const int n_nodes : {6, 7, 8})
    {
      const BlockMatrix     m = unsymmetric_block_matrix(n_blocks, n_nodes, 1.);
      const Eigen::MatrixXd s = falling_stiffness(2 * n_nodes), full = expected(m, s);
      InterfaceStiffness    foundation;
      foundation.set(&s);
      JoinedMatrix          joined;
      const Eigen::MatrixXd found = dense(joined.join(m, foundation));
      const int             n     = static_cast<int>(full.rows());
      ASSERT_EQ(found.rows(), 6 * (n_blocks + JoinedMatrix::n_added(n_nodes)));
      EXPECT_LT((found.topLeftCorner(n, n) - full).cwiseAbs().maxCoeff(), 1e-3 * s(0, 0));
      // Beside the nodes that the last block lacks there is nothing.
      const int rest = static_cast<int>(found.rows()) - n;
      EXPECT_TRUE(found.bottomRightCorner(rest, rest).isIdentity(0.));
      EXPECT_TRUE(found.topRightCorner(n, rest).isZero(0.));
      EXPECT_TRUE(found.bottomLeftCorner(rest, n).isZero(0.));
    }
}



TEST(JoinedMatrix, has_nothing_of_the_matrix_before)
{
  BlockMatrix           m = unsymmetric_block_matrix(n_blocks, 6, 1.);
  const Eigen::MatrixXd s = falling_stiffness(12);
  InterfaceStiffness    foundation;
  foundation.set(&s);
  JoinedMatrix used, fresh;
  used.join(m, foundation);
  for (auto &entry : m.block_node)
    entry *= -2.;
  for (Mat6 &entry : m.lower)
    entry.setRandom();
  m.node_next[1].setRandom();
  EXPECT_EQ(dense(used.join(m, foundation)), dense(fresh.join(m, foundation)));
}
