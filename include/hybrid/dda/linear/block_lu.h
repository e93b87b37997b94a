// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_matrix.h>
#include <hybrid/restart/archive_forward.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace hybrid::dda
{
  /**
   * LU factors of the blocks' part of a BlockMatrix whose blocks hardly touch.
   *
   * Of the pairs that loose blocks might have only some touch; the others are zero. Without them
   * the graph of a heap falls into pieces and chains, and elimination in the order of least degree
   * (Tinney and Walker 1967, their scheme 2) fills in so little that a general solver spends its
   * time on book-keeping. Rows are exchanged within the 6x6 blocks of the diagonal only: inertia
   * and elasticity make these regular. Where that does not suffice, because entries grow or a block
   * is nearly singular, there are no factors.
   */
  class BlockLu
  {
  public:
    /// Choose the order of elimination for the pairs of @p matrix that are not zero; kept from the
    /// last call if the same pairs are.
    /// @return how many products of 6x6 blocks factorize() takes; more than @p most, and no order,
    /// where it takes more than that.
    long analyze(const BlockMatrix &matrix, long most = std::numeric_limits<long>::max());

    /// @pre analyze() has found an order for this matrix. @return false if a block of the diagonal
    /// becomes nearly singular or large.
    bool factorize(const BlockMatrix &matrix);

    /// x = K^-1 b for the first 6 n_blocks entries.
    void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) const;

    /// 6x6 blocks of the factors.
    double n_entries() const
    {
      return static_cast<double>(block.size() + 2 * later.size());
    }

    /// Order and factors, for the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    std::vector<int> place; ///< of each block in the order of elimination
    std::vector<int> block; ///< at each place
    // U has the rows of a place and the columns of its neighbours at later places, L the reverse.
    std::vector<int>  begin;   ///< CSR over places
    std::vector<int>  later;   ///< places of the neighbours, ascending
    std::vector<Mat6> upper;   ///< U off the diagonal
    std::vector<Mat6> lower;   ///< L off the diagonal; its diagonal is the unit matrix
    std::vector<Mat6> inverse; ///< of the diagonal of U

    // What was analysed last: the order depends on nothing else.
    std::vector<BlockMatrix::Pair> analyzed;          ///< pairs
    int                            n_analyzed   = -1; ///< blocks; -1: nothing
    long                           most_allowed = 0;  ///< products
    long                           n_products   = 0;  ///< that it came to

    std::vector<BlockMatrix::Pair> touching;   ///< work: pairs that are not zero
    std::vector<Mat6>              diagonal;   ///< work: what is left of it
    std::vector<std::vector<int>>  neighbours; ///< work: of each block, those not yet eliminated
    std::vector<std::vector<int>>  by_degree;  ///< work: blocks, some of them outdated
    std::vector<int>               joined;     ///< work

    /// Fill neighbours with the pairs that touch.
    void connect();

    /// Take a block out of the graph: its neighbours become neighbours of each other.
    void eliminate(int b);

    /// Fill place, block and, but for the order, the neighbours of all blocks at later places, and
    /// count products, as long as they are no more than @p most.
    void choose_order(long most);

    void set_pattern();

    /// Entry of the pair of places @p row < @p column.
    std::size_t entry(int row, int column) const;

    void load(const BlockMatrix &matrix);

    /// Subtract what the elimination of a place leaves in later rows and columns.
    void update_later(int p);
  };
} // namespace hybrid::dda
