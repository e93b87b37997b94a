// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"

#include <hybrid/dda/swept_system.h>

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::dense;
  using hybrid::test::random_block_matrix;
  using hybrid::test::unsymmetric_block_matrix;

  constexpr int n_blocks = 15, n_nodes = 8;

  /// A, and its parts below, on and above the diagonal as the class defines them.
  struct Parts
  {
    Eigen::MatrixXd a, lower, diagonal, upper;

    /// @p base: S, or nothing.
    Parts(const BlockMatrix &m, const Eigen::MatrixXd *base)
      : a(dense(m))
      , lower(Eigen::MatrixXd::Zero(m.size(), m.size()))
      , diagonal(Eigen::MatrixXd::Zero(m.size(), m.size()))
      , upper(lower)
    {
      const int nodes = 2 * m.n_nodes(), first = 6 * m.n_blocks();
      for (int i = 0; i < first; i += 6)
        {
          diagonal.block(i, i, 6, 6)                 = a.block(i, i, 6, 6);
          lower.block(i, 0, 6, i)                    = a.block(i, 0, 6, i);
          upper.block(i, i + 6, 6, m.size() - i - 6) = a.block(i, i + 6, 6, m.size() - i - 6);
        }
      lower.bottomLeftCorner(nodes, first) = a.bottomLeftCorner(nodes, first);
      auto own                             = diagonal.bottomRightCorner(nodes, nodes);
      own.setIdentity();
      if (base != nullptr)
        {
          own = *base;
          a.bottomRightCorner(nodes, nodes) += *base;
        }
    }
  };

  void check(const BlockMatrix &m, const Eigen::MatrixXd *stiffness)
  {
    BaseBand base;
    base.set(stiffness);
    base.matrix_changed(m);
    SweptSystem swept;
    swept.set(m, base);
    const Parts           parts(m, stiffness);
    const Eigen::MatrixXd forward = parts.diagonal + parts.lower;
    const Eigen::MatrixXd back    = (parts.diagonal + parts.upper).lu().solve(parts.diagonal);
    const Eigen::VectorXd x       = Eigen::VectorXd::Random(m.size());
    Eigen::VectorXd       y(m.size());
    const auto            expect = [&](const Eigen::VectorXd &expected) {
      EXPECT_LT((y - expected).norm(), 1e-11 * expected.norm());
    };
    swept.multiply(x, y);
    expect(forward.lu().solve(parts.a * back * x));
    swept.sweep_forward(x, y);
    expect(forward.lu().solve(x));
    swept.sweep_backward(x, y);
    expect(back * x);
    swept.multiply_diagonal(x, y);
    expect(parts.diagonal * x);
    swept.undo_forward(x, y);
    expect(forward * x);
  }

  /// So stiff that joints and contacts do not count beside it.
  Eigen::MatrixXd stiff_base()
  {
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random(2 * n_nodes, 2 * n_nodes);
    return 1e3 * (a * a.transpose() + Eigen::MatrixXd::Identity(2 * n_nodes, 2 * n_nodes));
  }
} // namespace



TEST(SweptSystem, symmetric_matrix_with_a_base)
{
  const Eigen::MatrixXd s = stiff_base();
  check(random_block_matrix(n_blocks, n_nodes), &s);
}



TEST(SweptSystem, unsymmetric_matrix_with_a_base)
{
  const Eigen::MatrixXd s = stiff_base();
  check(unsymmetric_block_matrix(n_blocks, n_nodes, 0.05), &s);
}



TEST(SweptSystem, nodes_without_a_base)
{
  check(unsymmetric_block_matrix(n_blocks, n_nodes, 0.05), nullptr);
}



TEST(SweptSystem, blocks_alone)
{
  check(random_block_matrix(n_blocks, 0), nullptr);
}
