// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_lu.h>
#include <hybrid/dda/linear/block_matrix.h>
#include <hybrid/dda/linear/frontal_lu.h>
#include <hybrid/dda/linear/joined_matrix.h>

#include <Eigen/Core>

namespace hybrid::dda
{
  /**
   * Sparse factor of the blocks' part of a BlockMatrix: BlockLu where few blocks touch and joints
   * slide with friction or soften, else FrontalLu, whose analysis is kept.
   */
  class SparseFactor
  {
  public:
    /// Blocks from which the copy that JoinedMatrix makes is given back before it is factored.
    static constexpr int many_blocks = 16000;

    /// See FrontalLu; the other kinds of factors are made by each process for itself.
    void set_processes(const ProcessGroup *processes)
    {
      frontal.set_processes(processes);
    }

    /// Of the blocks' part, or of blocks and @p foundation together if LU by fronts serves:
    /// has_foundation(). @return false if the matrix is singular, or entries of the
    /// factors grow too much.
    bool factorize(const BlockMatrix &matrix, const InterfaceStiffness *foundation = nullptr);

    /// What a factor takes, in 6x6 blocks.
    struct Counts
    {
      double entries;  ///< read in a solution
      double products; ///< in a factorisation
      double fronts;   ///< as many pieces
    };

    /// Of the last factor; before the first one, what nested dissection of a mass in the plane
    /// takes.
    Counts counts(int n_blocks) const;

    /// The last factor was BlockLu's.
    bool is_block_lu() const
    {
      return kind == Kind::block_lu;
    }

    /// The last factor is that of a symmetric matrix.
    bool is_symmetric() const
    {
      return symmetric;
    }

    /// The last factor is of blocks and foundation.
    bool has_foundation() const
    {
      return n_added > 0;
    }

    /// True if a factor of this size is there.
    bool ready(int n_blocks) const;

    /// For the checkpoint: what was factored is stored, and factored again when read.
    void serialize(restart::Archive &archive);

    /// x = K^-1 b for the first 6 n_blocks entries, of has_foundation() x = (K + S)^-1 b for all.
    void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x);

  private:
    bool factorize_joined(const BlockMatrix &matrix, const InterfaceStiffness &foundation);

    /// For right-hand sides with the foundation.
    void make_room();

    enum class Kind
    {
      frontal,
      block_lu
    };

    FrontalLu       frontal;
    BlockLu         block_lu;
    JoinedMatrix    joined;
    Eigen::VectorXd padded;                ///< work, with the foundation
    int             size              = 0; ///< of the factor there is, 0: none
    int             n_added           = 0; ///< blocks of nodes in it
    Kind            kind              = Kind::frontal;
    bool            symmetric         = false;
    double          block_lu_products = 0.;
  };
} // namespace hybrid::dda
