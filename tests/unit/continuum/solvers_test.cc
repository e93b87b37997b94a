// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/condensed_factor.h>
#include <hybrid/continuum/lagrange_line.h>

#include <Eigen/Cholesky>
#include <Eigen/Dense>

#include "grid_matrix.h"

#include <omp.h>

#include <cmath>
#include <random>

namespace
{
  using namespace hybrid::continuum;
  using hybrid::test::GridMatrix;

  /// Positive definite, random pattern of about four off-diagonal entries a row.
  Eigen::MatrixXd random_sparse_matrix(const int n, const unsigned int seed)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> value(-1., 1.);
    std::uniform_int_distribution<int>     index(0, n - 1);
    Eigen::MatrixXd                        a = 12. * Eigen::MatrixXd::Identity(n, n);
    for (int k = 0; k < 2 * n; ++k)
      {
        const int i = index(generator), j = index(generator);
        if (i != j)
          a(i, j) = a(j, i) = value(generator);
      }
    return a;
  }
} // namespace


TEST(LagrangeLine, integrals)
{
  for (const int degree : {1, 2, 5, 8})
    {
      const LagrangeLine line(degree);
      EXPECT_NEAR(line.mass().sum(), 1., 1e-13);
      EXPECT_NEAR(line.stiffness().rowwise().sum().norm(), 0., 1e-11);
      Eigen::VectorXd x(degree + 1);
      for (int i = 0; i <= degree; ++i)
        x[i] = line.nodes()[i];
      EXPECT_NEAR(x.dot(line.stiffness() * x), 1., 1e-12); // int 1
      EXPECT_NEAR((line.gradient() * x).sum(), 1., 1e-12); // int 1
      EXPECT_NEAR(x.dot(line.mass() * x), 1. / 3., 1e-13); // int x^2
    }
}


TEST(CondensedFactor, equals_dense_condensation)
{
  const int             n = 200, ns = 23, ni = n - ns;
  const Eigen::MatrixXd a     = random_sparse_matrix(n, 5);
  std::vector<int>      start = {0}, row;
  std::vector<double>   values;
  for (int j = 0; j < n; ++j)
    {
      for (int i = j; i < n; ++i)
        if (a(i, j) != 0.)
          {
            row.push_back(i);
            values.push_back(a(i, j));
          }
      start.push_back(static_cast<int>(row.size()));
    }
  CondensedFactorisation system(start, row, ns);
  const auto             factor = system.factor(values);

  const Eigen::MatrixXd coupling = a.bottomLeftCorner(ns, ni);
  const auto            inner    = a.topLeftCorner(ni, ni).ldlt();
  const Eigen::MatrixXd s =
    a.bottomRightCorner(ns, ns) - coupling * inner.solve(coupling.transpose());
  EXPECT_LT((system.surface_stiffness(*factor).dense() - s).norm(), 1e-12 * s.norm());

  std::vector<double> b(n), x(n);
  for (int i = 0; i < n; ++i)
    b[i] = std::sin(i + 1.);
  Eigen::Map<Eigen::VectorXd> rhs(b.data(), n), solution(x.data(), n);
  Eigen::VectorXd             g(ns);
  system.forward(*factor, b, g);
  EXPECT_LT((g - (rhs.tail(ns) - coupling * inner.solve(rhs.head(ni)))).norm(), 1e-12);
  system.backward(*factor, x);
  EXPECT_LT((solution - a.ldlt().solve(rhs)).norm(), 1e-12);

  const Eigen::VectorXd given = Eigen::VectorXd::LinSpaced(ns, -1., 1.);
  system.forward(*factor, b, g);
  system.backward(*factor, given, x);
  EXPECT_LT((solution.tail(ns) - given).norm(), 1e-13);
  EXPECT_LT((solution.head(ni) - inner.solve(rhs.head(ni) - coupling.transpose() * given)).norm(),
            1e-12);

  rhs.head(ni).setZero();
  system.solve_load_on_surface(*factor, rhs.tail(ns), x);
  EXPECT_LT((solution - a.ldlt().solve(rhs)).norm(), 1e-12);

  values.front() = -1.;
  EXPECT_THROW(system.factor(values), std::runtime_error);
}


TEST(CondensedFactor, has_the_same_bits_for_any_number_of_threads)
{
  const int              nx = 240, ny = 60;
  const GridMatrix       grid(nx, ny);
  CondensedFactorisation system(grid.start, grid.row, 2 * nx);
  const auto             factor = system.factor(grid.values);
  std::vector<double>    b(grid.size);
  for (int i = 0; i < grid.size; ++i)
    b[i] = std::sin(i + 1.);
  const int                        usual = omp_get_max_threads();
  std::vector<std::vector<double>> solutions;
  for (const int threads : {1, 2, 3})
    {
      omp_set_num_threads(threads);
      std::vector<double> x(grid.size);
      Eigen::VectorXd     g(2 * nx);
      system.forward(*factor, b, g);
      system.backward(*factor, g, x);
      x.insert(x.end(), g.data(), g.data() + g.size());
      solutions.push_back(x);
    }
  omp_set_num_threads(usual);
  EXPECT_EQ(solutions[0], solutions[1]);
  EXPECT_EQ(solutions[0], solutions[2]);
}


TEST(CondensedFactor, solves_many_and_leaves_the_substitution_of_a_step)
{
  const int              nx = 12, ny = 9;
  const GridMatrix       grid(nx, ny);
  CondensedFactorisation system(grid.start, grid.row, 2 * nx);
  const auto             factor = system.factor(grid.values);
  const Eigen::MatrixXd  a      = grid.dense();
  std::vector<double>    b(grid.size, 1.), before(grid.size), after(grid.size);
  Eigen::VectorXd        g(2 * nx);
  system.forward(*factor, b, g);
  system.backward(*factor, before);
  const Eigen::MatrixXd loads = Eigen::MatrixXd::Identity(grid.size, 5);
  Eigen::MatrixXd       x     = loads;
  system.solve(*factor, x);
  EXPECT_LT((a * x - loads).norm(), 1e-12);
  system.backward(*factor, after);
  EXPECT_EQ(before, after);
}
