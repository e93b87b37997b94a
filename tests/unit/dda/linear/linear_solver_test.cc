// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"

#include <hybrid/dda/linear/linear_solver.h>
#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>

#include <numeric>

#include <Eigen/LU>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::dense;
  using hybrid::test::random_block_matrix;
  using hybrid::test::unsymmetric_block_matrix;

  /// Banded stiffness of the foundation, as of a chain of nodes with neighbours up to three apart.
  Eigen::MatrixXd foundation_stiffness(const int n)
  {
    Eigen::MatrixXd s = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = std::max(0, i - 3); j <= std::min(n - 1, i + 3); ++j)
        s(i, j) = i == j ? 5. : -0.5 / std::abs(i - j);
    return s;
  }

  std::vector<int> all_blocks(const BlockMatrix &matrix)
  {
    std::vector<int> blocks(matrix.n_blocks());
    std::iota(blocks.begin(), blocks.end(), 0);
    return blocks;
  }

  /// Solve and compare with a dense factorisation.
  LinearSolver::Result
  check(LinearSolver &solver, BlockMatrix &matrix, const Eigen::MatrixXd *foundation)
  {
    Eigen::MatrixXd full = dense(matrix);
    if (foundation != nullptr)
      full.bottomRightCorner(foundation->rows(), foundation->cols()) += *foundation;
    const Eigen::VectorXd b     = Eigen::VectorXd::Random(matrix.size());
    const Eigen::VectorXd scale = Eigen::VectorXd::Ones(matrix.size());
    Eigen::VectorXd       x;
    solver.set_foundation_stiffness(foundation);
    solver.matrix_changed(matrix, all_blocks(matrix));
    const LinearSolver::Result result = solver.solve(matrix, b, scale, 1e-12 * b.norm(), x);
    EXPECT_TRUE(result.converged);
    const Eigen::VectorXd expected = full.lu().solve(b);
    EXPECT_LT((x - expected).norm(), 1e-9 * expected.norm());
    return result;
  }

  /// Springs of stiffness k between the first of every @p step pairs of blocks.
  void
  stiffen(BlockMatrix &m, const double k, const std::size_t first = 0, const std::size_t step = 1)
  {
    for (std::size_t s = first; s < m.pairs.size(); s += step)
      {
        Vec6 a = Vec6::Zero(), b = Vec6::Zero();
        a << 1., 0.5, 0.1, 0.2, 0.3, 0.4;
        b << 1., 0.4, -0.1, 0.1, 0.3, 0.2;
        m.diagonal[m.pairs[s][0]] += k * a * a.transpose();
        m.diagonal[m.pairs[s][1]] += k * b * b.transpose();
        m.off_diagonal[s] -= k * a * b.transpose();
        m.lower[s] -= k * b * a.transpose();
      }
  }
} // namespace



TEST(LinearSolver, inertia_dominates_diagonal_blocks_suffice)
{
  BlockMatrix m = random_block_matrix(20, 6);
  for (Mat6 &block : m.diagonal)
    block += 10. * Mat6::Identity();
  LinearSolver solver;
  EXPECT_FALSE(check(solver, m, nullptr).factored);
}



TEST(LinearSolver, no_right_hand_side_no_iterations)
{
  BlockMatrix  m = random_block_matrix(3, 0);
  LinearSolver solver;
  solver.matrix_changed(m, all_blocks(m));
  Eigen::VectorXd            x;
  const Eigen::VectorXd      zero = Eigen::VectorXd::Zero(18), one = Eigen::VectorXd::Ones(18);
  const LinearSolver::Result result = solver.solve(m, zero, one, 1e-12, x);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(x.norm(), 0.);
}



TEST(LinearSolver, stiff_springs_need_a_factor_which_is_kept)
{
  BlockMatrix m = random_block_matrix(60, 0);
  stiffen(m, 1e5);
  LinearSolver solver;
  EXPECT_TRUE(check(solver, m, nullptr).factored);
  stiffen(m, 1e3); // one percent: the old factor still serves
  const LinearSolver::Result second = check(solver, m, nullptr);
  EXPECT_FALSE(second.factored);
  EXPECT_LE(second.iterations, 25);
}



// Many contacts change from one matrix to the next, then few: old factors are not tried, then serve
// again.
TEST(LinearSolver, old_factors_that_fail_are_passed_over)
{
  LinearSolver solver;
  const auto   solve = [&](const std::size_t first, const double more) {
    BlockMatrix m = random_block_matrix(60, 0);
    stiffen(m, 1e5, first, 3);
    stiffen(m, more);
    return check(solver, m, nullptr);
  };
  solve(0, 0.);
  for (const std::size_t first : {1, 2})
    EXPECT_GT(solve(first, 0.).iterations, 2);
  const LinearSolver::Result passed_over = solve(0, 0.);
  EXPECT_TRUE(passed_over.factored);
  EXPECT_LE(passed_over.iterations, 2);

  int factored = 0;
  for (int k = 0; k < 20; ++k)
    factored += solve(0, 1e-3 * k).factored ? 1 : 0;
  EXPECT_LT(factored, 20); // a factor of so few blocks is cheap: PreconditionerChoice's tests count
}



// Blocks first, then the foundation: in one place after the other, not each as if there were no
// other.
TEST(LinearSolver, a_factor_and_a_base_take_few_iterations)
{
  constexpr int         swept      = 40; // tried before
  BlockMatrix           m          = random_block_matrix(60, 8);
  const Eigen::MatrixXd foundation = foundation_stiffness(16);
  stiffen(m, 1e5);
  LinearSolver               solver;
  const LinearSolver::Result result = check(solver, m, &foundation);
  EXPECT_TRUE(result.factored);
  EXPECT_LE(result.iterations, swept + 8);
}



// A base whose stiffness has no tails is in the factor of a symmetric matrix whole.
TEST(LinearSolver, a_factor_with_the_base_solves_in_two_iterations)
{
  BlockMatrix           m          = random_block_matrix(60, 8);
  const Eigen::MatrixXd foundation = foundation_stiffness(16);
  stiffen(m, 1e5);
  LinearSolver solver;
  ASSERT_TRUE(check(solver, m, &foundation).factored);
  const LinearSolver::Result again = check(solver, m, &foundation);
  EXPECT_LE(again.iterations, 2); // round-off of springs of 1e5
}



// Joints between blocks and base that are stiff beside both: the blocks follow the base, whose own
// stiffness is all that is left.
TEST(LinearSolver, stiff_joints_on_the_base_take_few_iterations)
{
  constexpr int         swept      = 40;
  BlockMatrix           m          = random_block_matrix(60, 8);
  const Eigen::MatrixXd foundation = 100. * foundation_stiffness(16);
  for (std::size_t s = 0; s < m.couplings.size(); ++s)
    {
      const Vec6            a = 1e3 * Vec6::Random();
      const Eigen::Vector2d c = 1e3 * Eigen::Vector2d::Random();
      m.diagonal[m.couplings[s][0]] += a * a.transpose();
      m.node_diagonal[m.couplings[s][1]] += c * c.transpose();
      m.block_node[s] -= a * c.transpose();
      m.node_block[s] -= c * a.transpose();
    }
  LinearSolver               solver;
  const LinearSolver::Result result = check(solver, m, &foundation);
  EXPECT_TRUE(result.factored);
  EXPECT_LE(result.iterations, swept + 8);
}



TEST(LinearSolver, base_with_a_banded_stiffness_of_its_own)
{
  BlockMatrix           m = random_block_matrix(15, 8);
  const Eigen::MatrixXd s = foundation_stiffness(16);
  LinearSolver          solver;
  check(solver, m, &s);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(m.size());
  Eigen::VectorXd       y(m.size());
  solver.multiply(m, x, y);
  Eigen::MatrixXd full = dense(m);
  full.bottomRightCorner(16, 16) += s;
  EXPECT_LT((y - full * x).norm(), 1e-13 * y.norm());
}



TEST(LinearSolver, changed_base_stiffness_at_the_same_address_is_noticed)
{
  BlockMatrix     m = random_block_matrix(15, 8);
  Eigen::MatrixXd s = foundation_stiffness(16);
  LinearSolver    solver;
  check(solver, m, &s);
  s *= 3.;
  check(solver, m, &s);
  check(solver, m, nullptr);
}



TEST(LinearSolver, unsymmetric_matrix_with_and_without_a_base)
{
  BlockMatrix           m = unsymmetric_block_matrix(15, 8, 0.05);
  const Eigen::MatrixXd s = foundation_stiffness(16);
  LinearSolver          solver;
  check(solver, m, &s);
  check(solver, m, nullptr);
}



// Sweeps with a foundation, and a kept factor of an earlier matrix.
TEST(LinearSolver, a_restored_solver_gives_the_same_bits)
{
  using hybrid::restart::Archive;
  for (const double stiffness : {0., 1e5})
    {
      BlockMatrix           m          = random_block_matrix(60, 8);
      const Eigen::MatrixXd foundation = foundation_stiffness(16);
      const Vec6            a = Vec6::LinSpaced(1., 2.), b = Vec6::LinSpaced(2., 0.5);
      for (std::size_t s = 0; s < m.pairs.size(); ++s)
        {
          m.diagonal[m.pairs[s][0]] += stiffness * a * a.transpose();
          m.diagonal[m.pairs[s][1]] += stiffness * b * b.transpose();
          m.off_diagonal[s] -= stiffness * a * b.transpose();
          m.lower[s] -= stiffness * b * a.transpose();
        }
      LinearSolver solver, copy;
      check(solver, m, &foundation);
      for (Mat6 &block : m.diagonal)
        block *= 1.01;
      check(solver, m, &foundation);

      BlockMatrix other;
      Archive     writer = Archive::writer();
      writer(m);
      solver.serialize(writer);
      Archive reader = Archive::reader(writer.content());
      reader(other);
      copy.serialize(reader);
      copy.set_foundation_stiffness(&foundation);
      copy.matrix_restored(other);

      const Eigen::VectorXd rhs   = Eigen::VectorXd::LinSpaced(m.size(), -1., 2.);
      const Eigen::VectorXd scale = Eigen::VectorXd::Ones(m.size());
      Eigen::VectorXd       x, y;
      const auto            first  = solver.solve(m, rhs, scale, 1e-10, x);
      const auto            second = copy.solve(other, rhs, scale, 1e-10, y);
      EXPECT_EQ(first.iterations, second.iterations);
      EXPECT_EQ(x, y) << stiffness;
    }
}
