// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"

#include <hybrid/dda/linear/interface_stiffness.h>

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>

namespace
{
  using namespace hybrid::dda;
  using hybrid::test::dense;
  using hybrid::test::random_block_matrix;

  constexpr int n_blocks = 6, n_nodes = 8, n_surface = 2 * n_nodes;

  /// Banded stiffness as of a chain of nodes, times @p factor.
  Eigen::MatrixXd chain(const double factor)
  {
    Eigen::MatrixXd s = Eigen::MatrixXd::Zero(n_surface, n_surface);
    for (int i = 0; i < n_surface; ++i)
      for (int j = std::max(0, i - 3); j <= std::min(n_surface - 1, i + 3); ++j)
        s(i, j) = factor * (i == j ? 5. : -0.5 / std::abs(i - j));
    return s;
  }

  /// S + P as the factor and as the products have it must be @p expected.
  void expect_matrix(const InterfaceStiffness &foundation, const Eigen::MatrixXd &expected)
  {
    const Eigen::VectorXd x       = Eigen::VectorXd::Random(n_surface);
    Eigen::VectorXd       product = Eigen::VectorXd::Zero(n_surface);
    foundation.add_product(x.data(), product.data());
    foundation.add_nodes(x.data(), product.data(), 1.);
    EXPECT_LT((product - expected * x).norm(), 1e-13 * product.norm());
    Eigen::VectorXd solution = product;
    foundation.solve(solution.data());
    EXPECT_LT((solution - x).norm(), 1e-12 * x.norm());
  }
} // namespace



TEST(InterfaceStiffness, stiff_base_is_factored_alone)
{
  const BlockMatrix     m = random_block_matrix(n_blocks, n_nodes);
  const Eigen::MatrixXd s = chain(1e4);
  InterfaceStiffness    foundation;
  foundation.set(&s);
  foundation.matrix_changed(m);
  expect_matrix(foundation, s);
}



TEST(InterfaceStiffness, soft_base_is_factored_with_what_joints_add)
{
  const BlockMatrix     m = random_block_matrix(n_blocks, n_nodes);
  const Eigen::MatrixXd s = chain(1.);
  InterfaceStiffness    foundation;
  foundation.set(&s);
  foundation.matrix_changed(m);
  expect_matrix(foundation, s + dense(m).bottomRightCorner(n_surface, n_surface));
}



TEST(InterfaceStiffness, unsymmetric_joints_count_with_their_symmetric_part)
{
  BlockMatrix m = random_block_matrix(n_blocks, n_nodes);
  m.node_diagonal[2](0, 1) += 0.4;
  m.node_next[3](1, 0) += 0.3;
  const Eigen::MatrixXd s = chain(1.), nodes = dense(m).bottomRightCorner(n_surface, n_surface);
  InterfaceStiffness    foundation;
  foundation.set(&s);
  foundation.matrix_changed(m);
  expect_matrix(foundation, s + 0.5 * (nodes + nodes.transpose()));
}



TEST(InterfaceStiffness, softening_that_would_make_it_indefinite_is_left_out)
{
  BlockMatrix m            = random_block_matrix(n_blocks, n_nodes);
  m.node_diagonal[0](0, 0) = -100.;
  const Eigen::MatrixXd s  = chain(1.);
  InterfaceStiffness    foundation;
  foundation.set(&s);
  foundation.matrix_changed(m);
  expect_matrix(foundation, s);
}



TEST(InterfaceStiffness, without_a_base_nothing_changes)
{
  InterfaceStiffness foundation;
  foundation.set(nullptr);
  foundation.matrix_changed(random_block_matrix(n_blocks, n_nodes));
  EXPECT_FALSE(foundation.exists());
  Eigen::VectorXd x = Eigen::VectorXd::Random(n_surface), same = x;
  foundation.solve(x.data());
  foundation.add_product(same.data(), x.data());
  EXPECT_EQ(x, same);
}



TEST(InterfaceStiffness, product_for_residuals_is_exact_to_round_off)
{
  // As of rock in a short step: entries fall from the diagonal on, beyond the 41st below 1e-9 of it
  // (single precision), beyond the 90th below round-off.
  const int       n = 150;
  Eigen::MatrixXd s(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      s(i, j) = (4. + std::sin(std::min(i, j))) * std::exp(-0.5 * std::abs(i - j));
  InterfaceStiffness foundation;
  foundation.set(&s);
  for (const bool rises : {false, true}) // the largest displacement far from where rows begin
    {
      Eigen::VectorXd x(n), y(n);
      for (int i = 0; i < n; ++i)
        {
          x[i] = std::sin(1.7 * i) * std::exp((rises ? 0.2 : -0.2) * i);
          y[i] = std::cos(i);
        }
      const Eigen::Matrix<long double, Eigen::Dynamic, 1> exact =
        y.cast<long double>() - s.cast<long double>() * x.cast<long double>();
      const Eigen::VectorXd bound =
        2e-15 * (s.cwiseAbs() * x.cwiseAbs() + y.cwiseAbs()) +
        Eigen::VectorXd::Constant(n, 2e-16 * s(0, 0) * x.cwiseAbs().maxCoeff());
      foundation.subtract_whole_product(x.data(), y.data());
      EXPECT_TRUE(
        ((y.cast<long double>() - exact).cast<double>().cwiseAbs().array() <= bound.array()).all());
    }
}
