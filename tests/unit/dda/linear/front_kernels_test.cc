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
      const MatrixXd a       = regular(n);
      MatrixXd       inverse = a;
      DenseInverse   kernel;
      kernel.reserve(n);
      ASSERT_TRUE(kernel.invert(view(inverse), any.data()));
      EXPECT_LT((inverse * a - MatrixXd::Identity(n, n)).norm(), 1e-12 * n);
    }
}



// The first half is singular: rows of other blocks are needed. So are they where entries grow.
TEST(FrontKernels, inverse_with_pivots_where_halves_do_not_serve)
{
  for (const double small : {0., 1e-9})
    {
      MatrixXd a = MatrixXd::Random(12, 12);
      a.topLeftCorner<6, 6>() *= small;
      MatrixXd                  inverse = a;
      const std::vector<double> largest(2, 1e4);
      DenseInverse              kernel;
      kernel.reserve(12);
      ASSERT_TRUE(kernel.invert(view(inverse), largest.data()));
      EXPECT_LT((inverse * a - MatrixXd::Identity(12, 12)).norm(), 1e-10);
    }
}



TEST(FrontKernels, no_inverse_of_a_singular_or_large_matrix)
{
  MatrixXd     singular = MatrixXd::Zero(12, 12), large = regular(12);
  DenseInverse kernel;
  kernel.reserve(12);
  EXPECT_FALSE(kernel.invert(view(singular), any.data()));
  const std::vector<double> less(2, 1.);
  EXPECT_FALSE(kernel.invert(view(large), less.data()));
}
