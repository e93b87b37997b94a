// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/swept_system.h>

#include <Eigen/LU>

namespace hybrid::dda
{
  void SweptSystem::set(const BlockMatrix &block_matrix, const BaseBand &base_band)
  {
    matrix = &block_matrix;
    base   = &base_band;
    inverse_diagonal.resize(matrix->n_blocks());
    above.resize(6 * matrix->n_blocks());
    place.resize(matrix->size());
#pragma omp parallel for schedule(static)
    for (int i = 0; i < matrix->n_blocks(); ++i)
      inverse_diagonal[i] = matrix->diagonal[i].partialPivLu().inverse();
  }



  void SweptSystem::sweep_backward(const Eigen::VectorXd &hat, Eigen::VectorXd &x)
  {
    const int n                   = matrix->n_blocks();
    x.tail(2 * matrix->n_nodes()) = hat.tail(2 * matrix->n_nodes());
    for (int i = n - 1; i >= 0; --i)
      {
        const Vec6 sum                         = matrix->row_above(i, x);
        Eigen::Map<Vec6>(above.data() + 6 * i) = sum;
        Eigen::Map<Vec6>(x.data() + 6 * i) =
          Eigen::Map<const Vec6>(hat.data() + 6 * i) - inverse_diagonal[i] * sum;
      }
  }



  void SweptSystem::sweep_forward(const Eigen::VectorXd &b, Eigen::VectorXd &result)
  {
    const int n = matrix->n_blocks();
    for (int i = 0; i < n; ++i)
      {
        const Vec6 rest = Eigen::Map<const Vec6>(b.data() + 6 * i) - matrix->row_below(i, result);
        Eigen::Map<Vec6>(result.data() + 6 * i).noalias() = inverse_diagonal[i] * rest;
      }
    result.tail(2 * matrix->n_nodes()) = b.tail(2 * matrix->n_nodes());
    matrix->add_blocks_to_nodes(result, result, -1.);
    base->solve(result.data() + 6 * n);
  }



  void SweptSystem::multiply(const Eigen::VectorXd &x, Eigen::VectorXd &y)
  {
    // A = (D + L) + (D + U) + (D_A - 2 D): with t = (D + U)^-1 D x the product is
    // t + (D + L)^-1 (U t + (D_A - D) t), and D_A differs from D at the nodes only.
    const int n = matrix->n_blocks(), m = 2 * matrix->n_nodes();
    sweep_backward(x, place);
    y.head(6 * n) = above;
    matrix->multiply_nodes(place, y);
    if (base->exists())
      base->add_nodes(place.data() + 6 * n, y.data() + 6 * n, -1.);
    else
      y.tail(m) -= place.tail(m);
    sweep_forward(y, y);
    y += place;
  }



  void SweptSystem::multiply_diagonal(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
  {
    const int n = matrix->n_blocks(), m = 2 * matrix->n_nodes();
    for (int i = 0; i < n; ++i)
      Eigen::Map<Vec6>(y.data() + 6 * i).noalias() =
        matrix->diagonal[i] * Eigen::Map<const Vec6>(x.data() + 6 * i);
    if (!base->exists())
      {
        y.tail(m) = x.tail(m);
        return;
      }
    y.tail(m).setZero();
    base->add_product(x.data() + 6 * n, y.data() + 6 * n);
    base->add_nodes(x.data() + 6 * n, y.data() + 6 * n, 1.);
  }



  void SweptSystem::undo_forward(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
  {
    const int n = matrix->n_blocks();
    multiply_diagonal(x, y);
    for (int i = 0; i < n; ++i)
      Eigen::Map<Vec6>(y.data() + 6 * i) += matrix->row_below(i, x);
    matrix->add_blocks_to_nodes(x, y);
  }
} // namespace hybrid::dda
