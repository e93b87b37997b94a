// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"

#include <hybrid/dda/linear/ssor_system.h>

#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/LU>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::dense;
  using hybrid::test::random_block_matrix;
  using hybrid::test::unsymmetric_block_matrix;

  constexpr int n_rows = 15, n_nodes = 8;

  /// Two slices: the first half of @p n blocks and the others.
  std::vector<int> two_slices(const int n = n_rows)
  {
    std::vector<int> slice(n, 0);
    std::fill(slice.begin() + (n + 1) / 2, slice.end(), 1);
    return slice;
  }



  /// A, and its parts below, on and above the diagonal as the class defines them.
  struct Parts
  {
    Eigen::MatrixXd a, lower, diagonal, upper;

    /// @p foundation: S, or nothing.  @p slice of each block.
    Parts(const BlockMatrix &m, const Eigen::MatrixXd *foundation, const std::vector<int> &slice)
      : a(dense(m))
      , lower(Eigen::MatrixXd::Zero(m.size(), m.size()))
      , diagonal(Eigen::MatrixXd::Zero(m.size(), m.size()))
      , upper(lower)
    {
      const int nodes = 2 * m.n_nodes(), first = 6 * m.n_blocks();
      for (int i = 0; i < first; i += 6)
        {
          diagonal.block(i, i, 6, 6) = a.block(i, i, 6, 6);
        }
      const SweepOrder order(m.n_blocks(), slice, m.pairs);
      for (int i = 0; i < m.n_blocks(); ++i)
        for (int j = 0; j < m.n_blocks(); ++j)
          if (i != j)
            (order.place[j] < order.place[i] ? lower : upper).block(6 * i, 6 * j, 6, 6) =
              a.block(6 * i, 6 * j, 6, 6);
      upper.topRightCorner(first, nodes)   = a.topRightCorner(first, nodes);
      lower.bottomLeftCorner(nodes, first) = a.bottomLeftCorner(nodes, first);
      auto own                             = diagonal.bottomRightCorner(nodes, nodes);
      own.setIdentity();
      if (foundation != nullptr)
        {
          own = *foundation;
          a.bottomRightCorner(nodes, nodes) += *foundation;
        }
    }
  };

  void
  check(const BlockMatrix &m, const Eigen::MatrixXd *stiffness, const std::vector<int> &slice = {})
  {
    InterfaceStiffness foundation;
    foundation.set(stiffness);
    foundation.matrix_changed(m);
    SsorSystem swept;
    swept.set_slices(slice);
    swept.set(m, foundation, {});
    const Parts           parts(m, stiffness, slice);
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
  Eigen::MatrixXd stiff_foundation()
  {
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random(2 * n_nodes, 2 * n_nodes);
    return 1e3 * (a * a.transpose() + Eigen::MatrixXd::Identity(2 * n_nodes, 2 * n_nodes));
  }
} // namespace



TEST(SsorSystem, symmetric_matrix_with_a_base)
{
  const Eigen::MatrixXd s = stiff_foundation();
  check(random_block_matrix(n_rows, n_nodes), &s);
}



TEST(SsorSystem, unsymmetric_matrix_with_a_base)
{
  const Eigen::MatrixXd s = stiff_foundation();
  check(unsymmetric_block_matrix(n_rows, n_nodes, 0.05), &s);
}



TEST(SsorSystem, nodes_without_a_base)
{
  check(unsymmetric_block_matrix(n_rows, n_nodes, 0.05), nullptr);
}



TEST(SsorSystem, blocks_alone)
{
  check(random_block_matrix(n_rows, 0), nullptr);
}



TEST(SsorSystem, slices_are_swept_before_the_blocks_between_them)
{
  const Eigen::MatrixXd s = stiff_foundation();
  check(unsymmetric_block_matrix(n_rows, n_nodes, 0.05), &s, two_slices());
}



TEST(SsorSystem, any_number_of_threads_gives_the_same_bits)
{
  constexpr int      many = 2100; // threads share loops over them
  const BlockMatrix  m    = random_block_matrix(many, 0);
  InterfaceStiffness foundation;
  foundation.set(nullptr);
  foundation.matrix_changed(m);
  SsorSystem swept;
  swept.set_slices(two_slices(many));
  swept.set(m, foundation, {});
  const Eigen::VectorXd x = Eigen::VectorXd::Random(m.size());
  Eigen::VectorXd       one(m.size()), two(m.size());
  const int             threads = omp_get_max_threads();
  omp_set_num_threads(1);
  swept.multiply(x, one);
  omp_set_num_threads(2);
  swept.multiply(x, two);
  omp_set_num_threads(threads);
  EXPECT_TRUE(one == two);
}



TEST(SsorSystem, what_gave_its_memory_back_has_the_same_bits_when_set_again)
{
  const BlockMatrix  m = unsymmetric_block_matrix(n_rows, 0, 0.05);
  InterfaceStiffness foundation;
  foundation.set(nullptr);
  SsorSystem swept;
  swept.set_slices(two_slices());
  EXPECT_FALSE(swept.is_set());
  const Eigen::VectorXd x = Eigen::VectorXd::Random(m.size());
  Eigen::VectorXd       before(m.size()), after(m.size());
  swept.set(m, foundation, {});
  EXPECT_TRUE(swept.is_set());
  swept.multiply(x, before);
  swept.release();
  EXPECT_FALSE(swept.is_set());
  swept.set(m, foundation, {});
  swept.multiply(x, after);
  EXPECT_EQ(before, after);
}



TEST(SsorSystem, pairs_that_part_and_touch_again)
{
  const BlockMatrix  touching = unsymmetric_block_matrix(n_rows, 0, 0.05);
  BlockMatrix        m        = touching;
  InterfaceStiffness foundation;
  foundation.set(nullptr);
  SsorSystem            swept;
  const Eigen::VectorXd x       = Eigen::VectorXd::Random(m.size());
  const auto            product = [&](SsorSystem &system, const std::vector<int> &changed) {
    Eigen::VectorXd y(m.size());
    system.set(m, foundation, changed);
    system.multiply(x, y);
    return y;
  };
  const Eigen::VectorXd all = product(swept, {});
  std::vector<int>      changed;
  for (std::size_t s = 0; s < m.pairs.size(); s += 2)
    {
      m.off_diagonal[s].setZero();
      m.lower[s].setZero();
      changed.insert(changed.end(), m.pairs[s].begin(), m.pairs[s].end());
    }
  check(m, nullptr);
  SsorSystem            fresh;
  const Eigen::VectorXd without = product(swept, changed);
  EXPECT_GT((without - all).norm(), 0.01 * all.norm());
  EXPECT_EQ(without, product(fresh, {}));
  m.off_diagonal = touching.off_diagonal;
  m.lower        = touching.lower;
  EXPECT_EQ(product(swept, changed), all);
}
