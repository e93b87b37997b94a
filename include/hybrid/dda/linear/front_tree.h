// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_matrix.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Order in which coupled blocks are eliminated, and the fronts of it (Duff and Reid 1983).
   *
   * A front is a set of blocks that are eliminated together, its own blocks, and the blocks that
   * these are coupled to by then, its later blocks. What the elimination leaves among the later
   * blocks goes into the front of the first of them, its parent. Fronts come after their children
   * (postorder). Order, fronts and their merging are CHOLMOD's: least degree (AMD) or nested
   * dissection (METIS), whichever fills in less.
   *
   * Sizes and products are counted in 6x6 blocks.
   */
  struct FrontTree
  {
    FrontTree() = default;

    /// @param pairs of coupled blocks (i, j), i < j, sorted, each once
    FrontTree(int n_blocks, const std::vector<BlockMatrix::Pair> &pairs);

    int n_fronts() const
    {
      return static_cast<int>(parent.size());
    }

    int n_blocks() const
    {
      return static_cast<int>(block.size());
    }

    /// Own blocks of a front.
    int own(const int f) const
    {
      return begin[f + 1] - begin[f];
    }

    /// Later blocks of a front.
    int later(const int f) const
    {
      return later_begin[f + 1] - later_begin[f];
    }

    /// Products of 6x6 blocks in the elimination of a front.
    double products_of(const int f) const
    {
      const double p = own(f), u = later(f);
      return p * p * p + p * p * u + p * u * u;
    }

    /// Position of a block among those of the front, own ones first. @param p place of the block
    int position(int f, int p) const;

    std::vector<int> block;          ///< at each place of the order
    std::vector<int> place;          ///< of each block
    std::vector<int> begin{0};       ///< first place of each front's own blocks, and the end
    std::vector<int> front;          ///< in which the block of each place is eliminated
    std::vector<int> parent;         ///< of each front; -1: none
    std::vector<int> later_begin{0}; ///< CSR over fronts
    std::vector<int> later_places;   ///< ascending
    std::vector<int> in_parent;      ///< position of each later block in the parent

    double entries  = 0.; ///< of the factors L and U together
    double products = 0.; ///< of 6x6 blocks in a factorisation

  private:
    void order(int n_blocks, const std::vector<BlockMatrix::Pair> &pairs);

    void find_parents();

    void count();
  };
} // namespace hybrid::dda
