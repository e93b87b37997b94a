// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/front_tree.h>
#include <hybrid/restart/archive_forward.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /**
   * LU factors of the blocks' part of a BlockMatrix by the multifrontal method (Duff and Reid
   * 1983), whether it is symmetric or not.
   *
   * The pattern is symmetric, so order and fronts (FrontTree) are found once for the pairs that are
   * not zero and kept while no other pair becomes so. Fronts are dense: their elimination is
   * products of dense matrices. With the own blocks D of a front, what it has on their right, B,
   * below, C, and among later blocks, E,
   *
   *     C D^-1,   E - (C D^-1) B
   *
   * are what is kept and what goes to the parent. Rows are exchanged within D only: inertia and
   * elasticity make it regular. Where that does not suffice entries grow, and there are no factors.
   */
  class FrontalLu
  {
  public:
    /// @return false if a block of the diagonal becomes singular or large.
    bool factorize(const BlockMatrix &matrix);

    /// x = K^-1 b for the first 6 n_blocks entries.
    void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x);

    /// Order and fronts that were used last.
    const FrontTree &fronts() const
    {
      return tree;
    }

    /// The analysis as often as it was made.
    int n_analyses() const
    {
      return analyses;
    }

    /// What was factored, and factored again when read, for the checkpoint. @param is_used false:
    /// the pairs alone, on which later orders depend.
    void serialize(restart::Archive &archive, bool is_used);

  private:
    /// Where a pair of blocks goes.
    struct Entry
    {
      int  pair;   ///< in pairs
      int  first;  ///< position of the one that is eliminated first
      int  second; ///< of the other
      bool turned; ///< the first is the second of the pair
    };

    int                            size      = 0; ///< blocks that were analysed
    int                            analyses  = 0;
    bool                           symmetric = false; ///< what was factored last
    std::vector<BlockMatrix::Pair> pairs;             ///< analysed
    FrontTree                      tree;
    std::vector<int>               entry_begin; ///< CSR over fronts
    std::vector<Entry>             entries;
    std::vector<Mat6>              diagonal, upper, lower; ///< what is factored, as in BlockMatrix
    std::vector<std::size_t>       factor_begin;           ///< of each front in factors
    std::vector<double> factors; ///< per front D^-1, C D^-1 and, unless symmetric, B; by columns
    std::vector<double> front, waiting;    ///< work
    std::vector<double> lapack_work;       ///< work
    std::vector<int>    pivots;            ///< work
    std::vector<int>    fronts_waiting;    ///< work
    Eigen::VectorXd     ordered, gathered; ///< work

    /// Bring order and fronts up to date, and copy the matrix.
    void load(const BlockMatrix &matrix);

    void analyze(std::vector<BlockMatrix::Pair> pairs_now, int n_blocks);

    /// Lay out the factors.
    void place_factors();

    bool eliminate();

    void fill(int f);

    /// Add what child fronts left. @param top of those that wait [entries of waiting]
    void add_child(int child, std::size_t top);

    void solve_forward(int f);

    void solve_backward(int f);

    bool invert_own(int f, double *inverse);

    /// An own block has become too large.
    bool grows(int f) const;
  };
} // namespace hybrid::dda
