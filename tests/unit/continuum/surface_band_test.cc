// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/surface_band.h>

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <stdexcept>

namespace
{
  using namespace hybrid::continuum;

  /// Positive definite; entries fall by exp(-1/fold) from one to the next, and the diagonal varies.
  Eigen::MatrixXd falling(const int n, const double fold)
  {
    return Eigen::MatrixXd::NullaryExpr(n, n, [=](const Eigen::Index i, const Eigen::Index j) {
      const double size = (2. + std::sin(0.3 * i)) * (2. + std::sin(0.3 * j));
      return size * std::exp(-std::abs(static_cast<double>(i - j)) / fold);
    });
  }

  struct Found
  {
    Eigen::MatrixXd band;
    int             columns = 0; ///< that were asked for
  };

  Found find(const Eigen::MatrixXd &s)
  {
    Found found;
    found.band = surface_band(
      [&](const Eigen::MatrixXd &x) {
        EXPECT_LE(x.cols(), columns_of_product);
        found.columns += static_cast<int>(x.cols());
        return Eigen::MatrixXd(s * x);
      },
      s.diagonal());
    return found;
  }

  /// Largest difference of the entries, those beyond the band included.
  double difference(const Eigen::MatrixXd &s, const Eigen::MatrixXd &band)
  {
    double largest = 0.;
    for (Eigen::Index j = 0; j < s.cols(); ++j)
      for (Eigen::Index i = j; i < s.rows(); ++i)
        largest =
          std::max(largest, std::abs(s(i, j) - (i - j < band.rows() ? band(i - j, j) : 0.)));
    return largest;
  }
} // namespace



TEST(SurfaceBand, entries_that_fall_away_are_found_with_few_columns)
{
  const Eigen::MatrixXd s     = falling(900, 1.);
  const Found           found = find(s);
  EXPECT_LT(found.band.rows(), 80);
  EXPECT_LT(found.columns, 200);
  EXPECT_LT(difference(s, found.band), 1e-14);
}



TEST(SurfaceBand, entries_that_reach_from_end_to_end_are_all_found)
{
  const Eigen::MatrixXd s     = falling(150, 60.);
  const Found           found = find(s);
  EXPECT_EQ(found.band.rows(), 150);
  EXPECT_LT(difference(s, found.band), 1e-14);
}



// Two places far from each other that no sample sees: the vector of signs does.
TEST(SurfaceBand, entries_that_samples_do_not_see_widen_it)
{
  Eigen::MatrixXd s = falling(900, 1.);
  s(301, 507) = s(507, 301) = 1e-9;
  const Found found         = find(s);
  EXPECT_GT(found.band.rows(), 206);
  EXPECT_LT(difference(s, found.band), 1e-14);
}



TEST(SurfaceBand, factor_solves)
{
  const Eigen::MatrixXd s = falling(300, 1.);
  Eigen::MatrixXd       l = find(s).band;
  factorise_band(l);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(300, -1., 1.);
  Eigen::VectorXd       x = b;
  solve_band(l, x.data());
  EXPECT_LT((s * x - b).norm(), 1e-12 * b.norm());
}



TEST(SurfaceBand, indefinite_matrix_is_refused)
{
  Eigen::MatrixXd band = Eigen::MatrixXd::Constant(2, 5, 1.);
  EXPECT_THROW(factorise_band(band), std::runtime_error);
}
