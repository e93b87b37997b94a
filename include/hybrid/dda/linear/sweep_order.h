// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block.h>

#include <array>
#include <vector>

namespace hybrid::dda
{
  /**
   * Order in which Gauss-Seidel sweeps visit the blocks, so that several
   * threads can sweep at once.
   *
   * The blocks of each part come together, in order of their numbers, and are
   * coupled to no other part: a block that couples to a part before its own
   * belongs to the separator, which comes last. A forward sweep takes all parts at
   * once, then the separator; a backward sweep the separator, then all parts. The order
   * depends on the blocks alone, so the bits do not depend on the number of
   * threads. (One level of nested dissection, George 1973.)
   */
  class SweepOrder
  {
  public:
    SweepOrder() = default;

    /// @param part of each block, from 0; empty: one part.  @param pairs of coupled blocks (i, j).
    SweepOrder(int                                    n_blocks,
               const std::vector<int>                &part,
               const std::vector<std::array<int, 2>> &pairs);

    /// Parts without the separator; at least one.
    int n_parts() const
    {
      return static_cast<int>(begin.size()) - 2;
    }

    std::vector<int> block;          ///< in sweeping order
    std::vector<int> place;          ///< of each block in @p block
    std::vector<int> begin{0, 0, 0}; ///< first place of each part, of the separator, and the end
  };


  /**
   * Part of each block: slices of equally many blocks across the longer side of
   * their extent. Too few blocks to share out are one part.
   *
   * @param centres of the blocks [m]
   */
  std::vector<int> slices(const std::vector<Vec2> &centres);
} // namespace hybrid::dda
