// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/index_range.h>

#include <array>
#include <vector>

namespace hybrid::dda
{
  /// Whom a spring connects.
  struct SpringBodies
  {
    int                block, other; ///< of P and Q, see Springs
    std::array<int, 2> node;         ///< foundation nodes of Q

    bool operator==(const SpringBodies &second) const
    {
      return block == second.block && other == second.other && node == second.node;
    }
  };


  /// The springs of each block and of the foundation.
  class SpringsOfBlocks
  {
  public:
    void sort(const std::vector<SpringBodies> &bodies, int n_blocks);

    int n_blocks() const
    {
      return static_cast<int>(block_begin.size()) - 2;
    }

    /// Twice the spring's number, plus 1 if the block is its other; ascending.
    IndexRange of_block(const int block) const
    {
      return {block_springs.data() + block_begin[block],
              block_springs.data() + block_begin[block + 1]};
    }

    /// Between a block and the foundation, ascending.
    const std::vector<int> &on_foundation() const
    {
      return foundation_springs;
    }

    /// How often they have been sorted.
    int version() const
    {
      return sorted;
    }

  private:
    int              sorted = 0;
    std::vector<int> block_begin;   ///< CSR over blocks of block_springs
    std::vector<int> block_springs; ///< of_block(), one after the other
    std::vector<int> foundation_springs;
  };
} // namespace hybrid::dda
