// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/banded_condensation.h>

#include <gtest/gtest.h>

#include "grid_matrix.h"

#include <omp.h>

#include <cmath>
#include <stdexcept>

namespace
{
  using namespace hybrid::continuum;
  using hybrid::test::GridMatrix;

  /// The same matrix condensed in both ways onto the last row of its grid.
  struct BothWays
  {
    int                                   n_surface;
    GridMatrix                            grid;
    CondensedFactorisation                dense;
    BandedCondensation                    banded;
    std::shared_ptr<Condensation::Factor> dense_factor, banded_factor;
    std::vector<double>                   b, of_dense, of_banded;

    BothWays(const int nx, const int ny)
      : n_surface(2 * nx)
      , grid(nx, ny)
      , dense(grid.start, grid.row, n_surface)
      , banded(grid.start, grid.row, n_surface, 60)
      , dense_factor(dense.factor(grid.values))
      , banded_factor(banded.factor(grid.values))
      , b(grid.size)
      , of_dense(grid.size)
      , of_banded(grid.size)
    {
      for (int i = 0; i < grid.size; ++i)
        b[i] = std::sin(i + 1.);
    }

    void expect_equal_solutions() const
    {
      for (int i = 0; i < grid.size; ++i)
        ASSERT_NEAR(of_banded[i], of_dense[i], 1e-13) << i;
    }
  };
} // namespace



TEST(BandedCondensation, stiffness_of_the_surface_is_the_dense_one)
{
  BothWays               both(400, 8);
  const SurfaceStiffness s = both.banded.surface_stiffness(*both.banded_factor);
  EXPECT_TRUE(s.is_band);
  EXPECT_LT(s.entries.rows(), both.n_surface / 4);
  const Eigen::MatrixXd all = both.dense.surface_stiffness(*both.dense_factor).dense();
  EXPECT_LT((s.dense() - all).cwiseAbs().maxCoeff(), 1e-13 * all.diagonal().minCoeff());
}



TEST(BandedCondensation, solutions_are_the_dense_ones)
{
  BothWays        both(200, 12);
  Eigen::VectorXd of_dense, of_banded;
  both.dense.forward(*both.dense_factor, both.b, of_dense);
  both.banded.forward(*both.banded_factor, both.b, of_banded);
  EXPECT_LT((of_dense - of_banded).norm(), 1e-13 * of_dense.norm());

  both.dense.backward(*both.dense_factor, both.of_dense);
  both.banded.backward(*both.banded_factor, both.of_banded);
  both.expect_equal_solutions();

  const Eigen::VectorXd surface = Eigen::VectorXd::LinSpaced(both.n_surface, -1., 1.);
  both.dense.backward(*both.dense_factor, surface, both.of_dense);
  both.banded.backward(*both.banded_factor, surface, both.of_banded);
  both.expect_equal_solutions();

  both.dense.solve_load_on_surface(*both.dense_factor, surface, both.of_dense);
  both.banded.solve_load_on_surface(*both.banded_factor, surface, both.of_banded);
  both.expect_equal_solutions();
}



TEST(BandedCondensation, solves_many_and_leaves_the_solution_of_a_step)
{
  BothWays        both(30, 9);
  Eigen::VectorXd g;
  both.banded.forward(*both.banded_factor, both.b, g);
  both.banded.backward(*both.banded_factor, both.of_dense);
  const Eigen::MatrixXd a = both.grid.dense(), loads = Eigen::MatrixXd::Identity(both.grid.size, 5);
  Eigen::MatrixXd       x = loads;
  both.banded.solve(*both.banded_factor, x);
  EXPECT_LT((a * x - loads).norm(), 1e-12);
  both.banded.backward(*both.banded_factor, both.of_banded);
  EXPECT_EQ(both.of_dense, both.of_banded);
}



TEST(BandedCondensation, has_the_same_bits_for_any_number_of_threads)
{
  const int                        usual = omp_get_max_threads();
  std::vector<std::vector<double>> solutions;
  for (const int threads : {1, 2, 3})
    {
      omp_set_num_threads(threads);
      BothWays        both(240, 60);
      Eigen::VectorXd g;
      both.banded.forward(*both.banded_factor, both.b, g);
      both.banded.backward(*both.banded_factor, g, both.of_banded);
      solutions.push_back(both.of_banded);
      solutions.back().insert(solutions.back().end(), g.begin(), g.end());
    }
  omp_set_num_threads(usual);
  EXPECT_EQ(solutions[0], solutions[1]);
  EXPECT_EQ(solutions[0], solutions[2]);
}



TEST(BandedCondensation, memory_grows_with_the_surface_not_with_its_square)
{
  const GridMatrix         small(500, 4), large(2000, 4);
  const BandedCondensation of_small(small.start, small.row, 1000, 60);
  const BandedCondensation of_large(large.start, large.row, 4000, 60);
  EXPECT_LT(of_large.factor_memory(), 4.5 * of_small.factor_memory());
  EXPECT_LT(of_large.factor_memory(),
            0.2 * CondensedFactorisation(large.start, large.row, 4000).factor_memory());
}



TEST(BandedCondensation, indefinite_matrix_is_refused)
{
  BothWays both(20, 5);
  both.grid.values.front() = -1.; // inside
  EXPECT_THROW(both.banded.factor(both.grid.values), std::runtime_error);
  both.grid.values.front() = 20.;
  both.grid.values.back()  = -1.; // on the surface
  EXPECT_THROW(both.banded.factor(both.grid.values), std::runtime_error);
}
