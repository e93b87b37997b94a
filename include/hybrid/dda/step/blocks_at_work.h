// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <vector>

namespace hybrid::dda
{
  /// The blocks that move in the trials of a step: all, or a few while the others are held.
  class BlocksAtWork
  {
  public:
    /// A step begins: all blocks are at work.
    void begin(const int n_blocks)
    {
      working.resize(n_blocks);
      std::iota(working.begin(), working.end(), 0);
      held.assign(n_blocks, 0);
    }

    /// Ascending.
    const std::vector<int> &at_work() const
    {
      return working;
    }

    bool is_held(const int block) const
    {
      return held[block] != 0;
    }

    /// Only these blocks, ascending, are at work until widen().
    void narrow(const std::vector<int> &blocks)
    {
      working.assign(blocks.begin(), blocks.end());
      held.assign(held.size(), 1);
      for (const int b : working)
        held[b] = 0;
    }

    void widen()
    {
      begin(static_cast<int>(held.size()));
    }

  private:
    std::vector<int>  working;
    std::vector<char> held; ///< per block
  };
} // namespace hybrid::dda
