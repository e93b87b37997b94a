// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense_supernodes.h"

#include <gtest/gtest.h>

#include <hybrid/continuum/substitution.h>

#include <Eigen/Dense>

#include <cmath>

namespace
{
  using namespace hybrid::continuum;

  /// Substitutions with a factor, and by dense matrices.
  struct Case
  {
    explicit Case(const DenseSupernodes &supernodes)
      : plan(supernodes.pattern())
      , numbers(plan.pack(supernodes.pattern(), supernodes.values.data()))
      , substitution(plan)
      , l(supernodes.matrix())
      , n(supernodes.n_interior)
      , b(Eigen::VectorXd::NullaryExpr(l.rows(),
                                       [](const Eigen::Index i) { return std::sin(i + 1.); }))
      , surface(Eigen::VectorXd::LinSpaced(supernodes.n_surface, -1., 2.))
    {}

    /// In the order of L, and back.
    Eigen::VectorXd turned(Eigen::VectorXd x) const
    {
      x.head(n).reverseInPlace();
      return x;
    }

    auto interior() const
    {
      return l.topRows(n).triangularView<Eigen::Lower>();
    }

    Eigen::VectorXd expected_backward(const Eigen::VectorXd &y) const
    {
      Eigen::VectorXd x(l.rows());
      x << l.topRows(n).transpose().triangularView<Eigen::Upper>().solve(
        y - l.bottomRows(surface.size()).transpose() * surface),
        surface;
      return turned(x);
    }

    SubstitutionPlan    plan;
    std::vector<double> numbers;
    Substitution        substitution;
    Eigen::MatrixXd     l;
    int                 n;
    Eigen::VectorXd     b, surface;
  };



  void expect_dense_solution(const DenseSupernodes &supernodes)
  {
    Case                  c(supernodes);
    const Eigen::VectorXd y = c.interior().solve(c.turned(c.b).head(c.n));
    Eigen::VectorXd       g, x(c.l.rows());
    c.substitution.forward(c.numbers.data(), c.b.data(), g);
    const Eigen::VectorXd left = c.b.tail(g.size()) - c.l.bottomRows(g.size()) * y;
    EXPECT_LT((g - left).norm(), 1e-13 * (1. + left.norm()));
    EXPECT_EQ(c.substitution.surface_load(), g);
    const Eigen::VectorXd from_surface = c.expected_backward(Eigen::VectorXd::Zero(c.n));
    c.substitution.backward_from_surface(c.numbers.data(), c.surface, x.data());
    EXPECT_LT((x - from_surface).norm(), 1e-13 * (1. + from_surface.norm()));
    const Eigen::VectorXd solution = c.expected_backward(y);
    for (int twice = 0; twice < 2; ++twice)
      {
        c.substitution.backward(c.numbers.data(), c.surface, x.data());
        EXPECT_LT((x - solution).norm(), 1e-13 * (1. + solution.norm()));
      }
  }
} // namespace


TEST(Substitution, of_two_levels_equals_dense_ones)
{
  expect_dense_solution(two_level_supernodes());
}


TEST(Substitution, of_any_width_equals_dense_ones)
{
  for (int width = 1; width <= 17; ++width)
    expect_dense_solution(DenseSupernodes({width}, {{width, width + 2}}, 3));
}


TEST(Substitution, without_a_surface_equals_dense_ones)
{
  expect_dense_solution(DenseSupernodes({2, 3}, {{2, 4}, {}}, 0));
}
