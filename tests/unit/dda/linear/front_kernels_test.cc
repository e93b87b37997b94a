// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/front_kernels.h>

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace
{
  using namespace hybrid::dda;
  using Eigen::MatrixXd;
  using Eigen::VectorXd;

  DenseView view(MatrixXd &m)
  {
    return {m.data(),
            static_cast<int>(m.rows()),
            static_cast<int>(m.cols()),
            static_cast<int>(m.rows())};
  }

  MatrixXd regular(const int n)
  {
    std::srand(3);
    return MatrixXd::Random(n, n) + 2. * std::sqrt(n) * MatrixXd::Identity(n, n);
  }

  /// Division by a matrix, which is as large as that of a test.
  struct Divisor
  {
    MatrixXd         matrix;
    std::vector<int> pivots;
    DenseInverse     kernel;

    explicit Divisor(const MatrixXd &m)
      : matrix(m)
      , pivots(m.rows())
    {
      kernel.reserve(static_cast<int>(m.rows()));
    }

    DenseDivisor get()
    {
      return {view(matrix), pivots.data()};
    }

    bool invert(const std::vector<double> &largest)
    {
      return kernel.invert(get(), largest.data());
    }
  };

  const std::vector<double> any(100, 1e300);
} // namespace



TEST(FrontKernels, products_of_all_sizes)
{
  for (const int n : {6, 12, 30, 240}) // the last is shared out
    for (const int k : {6, 60})
      {
        MatrixXd a = MatrixXd::Random(n, k), b = MatrixXd::Random(k, n), c = MatrixXd::Random(n, n);
        const MatrixXd expected = 2. * c - 3. * a * b;
        multiply(-3., view(a), view(b), 2., view(c));
        EXPECT_LT((c - expected).norm(), 1e-12 * expected.norm());
      }
}



TEST(FrontKernels, of_a_symmetric_product_the_part_below_the_diagonal_is_right)
{
  for (const int n : {6, 60, 150})
    {
      MatrixXd a = MatrixXd::Random(n, 12), b = MatrixXd::Random(n, 12), c = MatrixXd::Random(n, n);
      const MatrixXd expected = c - a * b.transpose();
      subtract_lower(view(a), view(b), view(c));
      for (int j = 0; j < n; ++j)
        EXPECT_LT((c - expected).col(j).tail(n - j).norm(), 1e-12 * expected.norm());
    }
}



TEST(FrontKernels, products_with_vectors)
{
  for (const int rows : {6, 24, 300})
    for (const int columns : {6, 18, 90})
      {
        MatrixXd       a = MatrixXd::Random(rows, columns);
        const VectorXd x = VectorXd::Random(columns), y = VectorXd::Random(rows);
        VectorXd       product(rows), less = y, turned = x;
        set_product(view(a), x.data(), product.data());
        subtract_product(view(a), x.data(), less.data());
        subtract_transposed_product(view(a), y.data(), turned.data());
        EXPECT_LT((product - a * x).norm(), 1e-12 * y.norm() * columns);
        EXPECT_LT((less - (y - a * x)).norm(), 1e-12 * y.norm() * columns);
        EXPECT_LT((turned - (x - a.transpose() * y)).norm(), 1e-12 * x.norm() * rows);
      }
}



TEST(FrontKernels, inverse_of_all_sizes)
{
  for (const int n : {6, 12, 18, 30, 66, 240})
    {
      const MatrixXd a = regular(n);
      Divisor        d(a);
      ASSERT_TRUE(d.invert(any));
      ASSERT_TRUE(d.get().is_inverse());
      EXPECT_LT((d.matrix * a - MatrixXd::Identity(n, n)).norm(), 1e-12 * n);
    }
}



// The first half is singular: rows of other blocks are needed. So are they where entries grow.
TEST(FrontKernels, factors_with_pivots_where_halves_do_not_serve)
{
  for (const double small : {0., 1e-9})
    {
      MatrixXd a = MatrixXd::Random(12, 12);
      a.topLeftCorner<6, 6>() *= small;
      Divisor d(a);
      ASSERT_TRUE(d.invert(std::vector<double>(2, 1e4)));
      ASSERT_FALSE(d.get().is_inverse());
      MatrixXd one = a, x(12, 12);
      divide(view(one), d.get(), view(x));
      EXPECT_LT((x - MatrixXd::Identity(12, 12)).norm(), 1e-10);
    }
}



// Held by little but its inertia: the inverse has few digits of what is in balance, factors all.
TEST(FrontKernels, a_nearly_singular_matrix_keeps_its_factors)
{
  for (const int n : {6, 30, 240})
    {
      // Springs between unknowns and their neighbours: their sum is free but for 1e-11.
      MatrixXd a = 1e-11 * MatrixXd::Identity(n, n);
      for (int i = 0; i + 1 < n; ++i)
        {
          const double k = 1. + std::abs(std::sin(3. * i));
          a(i, i) += k;
          a(i + 1, i + 1) += k;
          a(i, i + 1) -= k;
          a(i + 1, i) -= k;
        }
      Divisor d(a);
      ASSERT_TRUE(d.invert(any));
      ASSERT_FALSE(d.get().is_inverse());

      MatrixXd       rows = MatrixXd::Random(300, n) * a, quotient(300, n); // shared out if large
      const VectorXd b    = a * VectorXd::Random(n);
      VectorXd       x(n);
      divide(view(rows), d.get(), view(quotient));
      divide(b.data(), d.get(), x.data());
      EXPECT_LT((quotient * a - rows).norm(), 1e-9 * rows.norm());
      EXPECT_LT((a * x - b).norm(), 1e-9 * b.norm());
    }
}



TEST(FrontKernels, no_inverse_of_a_singular_or_large_matrix)
{
  EXPECT_FALSE(Divisor(MatrixXd::Zero(12, 12)).invert(any));
  EXPECT_FALSE(Divisor(regular(12)).invert(std::vector<double>(2, 1.)));
}
