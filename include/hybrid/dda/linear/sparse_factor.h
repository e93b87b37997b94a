// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_lu.h>
#include <hybrid/dda/linear/block_matrix.h>
#include <hybrid/dda/linear/frontal_lu.h>

#include <Eigen/Core>

#include <memory>

namespace hybrid::dda
{
  /**
   * Sparse factor of the blocks' part of a BlockMatrix: BlockLu where few blocks touch and joints
   * slide with friction or soften, else FrontalLu; UMFPACK, which exchanges rows, where entries of
   * these grow. Analyses of FrontalLu and UMFPACK are kept.
   */
  class SparseFactor
  {
  public:
    SparseFactor();
    ~SparseFactor();
    SparseFactor(const SparseFactor &)            = delete;
    SparseFactor &operator=(const SparseFactor &) = delete;

    /// @return false if the matrix is singular.
    bool factorize(const BlockMatrix &matrix);

    /// A new factor costs less than some iterations with this one.
    bool is_cheap() const
    {
      return kind == Kind::block_lu;
    }

    /// True if a factor of this size is there.
    bool ready(int n_blocks) const;

    /// For the checkpoint: what was factored is stored, and factored again when read. @param matrix
    /// as it stands now; the factor may be that of an earlier one.
    void serialize(restart::Archive &archive, const BlockMatrix &matrix);

    /// x = K^-1 b for the first 6 n_blocks entries.
    void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x);

  private:
    struct Lu;

    enum class Kind
    {
      frontal,
      lu,
      block_lu
    };

    std::unique_ptr<Lu> lu;
    FrontalLu           frontal;
    BlockLu             block_lu;
    int                 size = 0; ///< of the factor there is, 0: none
    Kind                kind = Kind::frontal;
  };
} // namespace hybrid::dda
