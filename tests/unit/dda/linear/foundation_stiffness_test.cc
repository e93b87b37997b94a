// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/foundation_stiffness.h>
#include <hybrid/dda/linear/interface_stiffness.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid::dda;

  constexpr int size = 40, reach = 6;

  /// Symmetric, positive definite, with entries at most reach from the diagonal.
  Eigen::MatrixXd narrow()
  {
    Eigen::MatrixXd s = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < size; ++i)
      for (int j = std::max(0, i - reach); j <= i; ++j)
        s(i, j) = s(j, i) = i == j ? 9. + std::sin(i) : std::cos(i + 3. * j) / (i - j);
    return s;
  }

  Eigen::MatrixXd rows_of(const Eigen::MatrixXd &s)
  {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(reach + 1, size);
    for (int j = 0; j < size; ++j)
      for (int r = 0; r <= reach && j + r < size; ++r)
        rows(r, j) = s(j + r, j);
    return rows;
  }
} // namespace



TEST(FoundationStiffness, none_has_no_entries)
{
  EXPECT_FALSE(FoundationStiffness().exists());
  EXPECT_FALSE(FoundationStiffness(nullptr).exists());
  EXPECT_EQ(FoundationStiffness().size(), 0);
}



TEST(FoundationStiffness, band_has_the_entries_of_the_matrix)
{
  const Eigen::MatrixXd     s = narrow(), rows = rows_of(s);
  const FoundationStiffness dense(&s), band    = FoundationStiffness::band(rows);
  EXPECT_EQ(dense.size(), size);
  EXPECT_EQ(band.size(), size);
  EXPECT_EQ(dense.reach(), size - 1);
  EXPECT_EQ(band.reach(), reach);
  EXPECT_EQ(dense.dense(), s);
  EXPECT_EQ(band.dense(), s);
  EXPECT_FALSE(dense == band);
  EXPECT_TRUE(band == FoundationStiffness::band(rows));
}



// All that solvers ask of it has the same bits.
TEST(FoundationStiffness, tangent_and_residual_are_those_of_the_matrix)
{
  const Eigen::MatrixXd s = narrow(), rows = rows_of(s);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size, -1., 2.);
  InterfaceStiffness    of_matrix, of_band;
  of_matrix.set(&s);
  of_band.set(FoundationStiffness::band(rows));
  EXPECT_EQ(of_matrix.near_width(), of_band.near_width());
  Eigen::VectorXd y = x, z = x;
  of_matrix.subtract_whole_product(x.data(), y.data());
  of_band.subtract_whole_product(x.data(), z.data());
  EXPECT_EQ(y, z);
  EXPECT_LT((x - s * x - y).norm(), 1e-13 * y.norm());
  of_matrix.solve_alone(y.data());
  of_band.solve_alone(z.data());
  EXPECT_EQ(y, z);
}
