// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block_matrix.h>

#include <Eigen/Core>

#include <memory>

namespace hybrid::dda
{
  /// Sparse Cholesky factor (CHOLMOD) of the blocks' part of a BlockMatrix; the analysis is kept
  /// with the pattern.
  class SparseFactor
  {
  public:
    SparseFactor();
    ~SparseFactor();
    SparseFactor(const SparseFactor &)            = delete;
    SparseFactor &operator=(const SparseFactor &) = delete;

    /// @return false if the matrix is not positive definite.
    bool factorize(const BlockMatrix &matrix);

    /// True if a factor of this size is there.
    bool ready(int n_blocks) const;

    /// x = K^-1 b for the first 6 n_blocks entries.
    void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> impl;
  };
} // namespace hybrid::dda
