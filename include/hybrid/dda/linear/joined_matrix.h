// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_matrix.h>
#include <hybrid/dda/linear/interface_stiffness.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /**
   * Blocks and the moving foundation as one matrix of 6x6 blocks, for a sparse factor of both:
   * three nodes are a block. Of the foundation's stiffness S it has the entries that count
   * (InterfaceStiffness::near_width()), so a factor of it is a preconditioner that lacks the tails
   * of S alone.
   */
  class JoinedMatrix
  {
  public:
    /// K + S of now. The result stays until the next call.
    const BlockMatrix &join(const BlockMatrix &matrix, const InterfaceStiffness &foundation);

    /// Blocks of nodes.
    static int n_added(const int n_nodes)
    {
      return (n_nodes + nodes_per_block - 1) / nodes_per_block;
    }

  private:
    static constexpr int nodes_per_block = 3;

    /// Where the entries of a node are.
    struct Place
    {
      int block, first; ///< and the first of its two unknowns in it
    };

    Place place_of(int node) const;

    void set_pattern(const BlockMatrix &matrix, int reach);

    void add_foundation(const InterfaceStiffness &foundation);

    /// Part of two nodes, a <= b, in the rows of a and the columns of b; and the other way round.
    void add(int a, int b, const Eigen::Matrix2d &above, const Eigen::Matrix2d &below);

    BlockMatrix      joined;
    int              n_blocks = 0, n_nodes = 0, reach_now = -1, version = -1;
    std::vector<int> of_pair, of_coupling; ///< slots in joined
  };
} // namespace hybrid::dda
