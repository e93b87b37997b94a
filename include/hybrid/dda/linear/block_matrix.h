// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block.h>
#include <hybrid/dda/linear/index_range.h>
#include <hybrid/restart/archive_forward.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace hybrid::dda
{
  /**
   * The matrix of blocks and foundation nodes, in small dense blocks.
   *
   * Unknowns: six per block, then two per foundation node. Stored are the diagonal
   * 6x6 blocks, one 6x6 blocks above and below the diagonal per coupled pair of
   * blocks, 6x2 and 2x6 blocks per coupled block and node, and the contacts' 2x2
   * blocks between a node and itself or the next. The foundation's own stiffness
   * belongs to the linear solver. The pattern is kept until pairs change.
   */
  class BlockMatrix
  {
  public:
    using Mat62 = Eigen::Matrix<double, 6, 2>;
    using Mat26 = Eigen::Matrix<double, 2, 6>;
    using Pair  = std::array<int, 2>;

    /// @param block_pairs (i, j), any order, repetitions allowed.  @param node_pairs (block, node).
    void set_pattern(int               n_blocks,
                     int               n_nodes,
                     std::vector<Pair> block_pairs,
                     std::vector<Pair> node_pairs);

    void set_zero();

    /// Entries between block i and blocks in the row of i, as set_zero() does for all.
    void set_row_zero(int i);

    /// Entries of nodes in all rows and columns; and take the matrix for symmetric.
    void set_nodes_zero();

    /// Slot of the pair (i, j) in off_diagonal, i < j; -1 if it is not in the pattern.
    int block_slot(int i, int j) const;

    /// Slot of (block, node) in block_node; -1 if it is not in the pattern.
    int node_slot(int block, int node) const;

    /// True if the blocks of a pair are not coupled in either direction: they do not touch.
    bool is_zero(const std::size_t pair) const
    {
      return off_diagonal[pair].isZero(0.) && lower[pair].isZero(0.);
    }

    /// y = K x (without the foundation's own stiffness). Same bits for any number of threads.
    void multiply(const Eigen::VectorXd &x, Eigen::VectorXd &y) const;

    /// Row i times x: columns of nodes.
    Vec6 row_of_nodes(int i, const Eigen::VectorXd &x) const;

    /// y_n = K_nn x_n for the entries of the nodes.
    void multiply_nodes(const Eigen::VectorXd &x, Eigen::VectorXd &y) const;

    /// y_n += sign K_nb x_b for the entries of the nodes; y may be x.
    void add_blocks_to_nodes(const Eigen::VectorXd &x, Eigen::VectorXd &y, double sign = 1.) const;

    int n_blocks() const
    {
      return static_cast<int>(diagonal.size());
    }

    int n_nodes() const
    {
      return static_cast<int>(node_diagonal.size());
    }

    /// Number of unknowns, 6 blocks + 2 nodes.
    int size() const
    {
      return 6 * n_blocks() + 2 * n_nodes();
    }

    /// Changes whenever set_pattern() is called.
    int pattern_version() const
    {
      return version;
    }

    /// Become the rows and columns of some blocks and nodes of @p whole, both ascending.
    void set_part(const BlockMatrix      &whole,
                  const std::vector<int> &blocks,
                  const std::vector<int> &nodes);

    /// Blocks that are coupled to a block.
    IndexRange blocks_at_block(const int block) const
    {
      return {row_other.data() + row_begin[block], row_other.data() + row_begin[block + 1]};
    }

    /// First coupling of a block with a node, and the one after its last.
    std::array<int, 2> couplings_of_block(const int block) const
    {
      return {coupling_begin[block], coupling_begin[block + 1]};
    }

    /// Couplings of a node with blocks.
    IndexRange couplings_of_node(const int node) const
    {
      return {node_coupling.data() + node_begin[node], node_coupling.data() + node_begin[node + 1]};
    }

    /// Pattern and entries, for the checkpoint.
    void serialize(restart::Archive &archive);

    std::vector<Mat6>  diagonal;
    std::vector<Mat6>  off_diagonal; ///< rows of block pairs[s][0], columns of pairs[s][1]
    std::vector<Mat6>  lower;        ///< rows of block pairs[s][1], columns of pairs[s][0]
    std::vector<Mat62> block_node;   ///< rows of the block, columns of the node
    std::vector<Mat26> node_block;   ///< rows of the node, columns of the block
    std::vector<Eigen::Matrix2d> node_diagonal;    ///< contacts' part only
    std::vector<Eigen::Matrix2d> node_next;        ///< rows of node k, columns of node k + 1
    std::vector<Eigen::Matrix2d> node_previous;    ///< rows of node k + 1, columns of node k
    bool                         symmetric = true; ///< as filled; set_zero() makes it true
    std::vector<Pair>            pairs;            ///< block pairs, sorted
    std::vector<Pair>            couplings;        ///< (block, node), sorted

  private:
    std::vector<int> pair_begin;     ///< CSR over the first block of pairs
    std::vector<int> row_begin;      ///< CSR over all blocks, both directions
    std::vector<int> row_other;      ///< the other block
    std::vector<int> row_slot;       ///< slot in off_diagonal; bit-complement: slot in lower
    std::vector<int> coupling_begin; ///< CSR over the block of couplings
    std::vector<int> node_begin;     ///< CSR over nodes
    std::vector<int> node_coupling;  ///< coupling of each node entry
    int              version = 0;
  };
} // namespace hybrid::dda
