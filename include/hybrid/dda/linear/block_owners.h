// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/geometry.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Which process owns a block: each has a region of the mass with as many blocks as the others, by
   * halving it across its longer side again and again (recursive coordinate bisection, Berger and
   * Bokhari 1987). A block that moves from one region to another gets another owner when the mass
   * is cut anew. Who owns what changes no bit of a result.
   */
  class BlockOwners
  {
  public:
    /// Cut the mass anew. @param centres of the blocks [m]
    void cut(const std::vector<Vec2> &centres, int n_processes);

    /// The process that owns a block.
    int of(const int block) const
    {
      return owner[block];
    }

  private:
    std::vector<int> order; ///< blocks, those of a region one after the other
    std::vector<int> owner; ///< of each block

    /// Give the blocks from place @p begin to @p end of the order to the processes from @p first
    /// on.
    void share_out(const std::vector<Vec2> &centres, int begin, int end, int first, int n);
  };
} // namespace hybrid::dda
