// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs/springs.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /**
   * Islands of blocks that are balanced before the others of a step.
   *
   * Blocks that springs connect in this step, open ones as well, are an island. On a base whose
   * motion is given no island knows of another. So one that is balanced stays where it is, with its
   * forces and rows of the tangent, while the others go on: a block that flies takes one iteration,
   * the heap below it twenty.
   */
  class SettledIslands
  {
  public:
    /// A step begins: all blocks are at work.
    void begin(int n_blocks);

    /// Blocks that are not settled, ascending.
    const std::vector<int> &at_work() const
    {
      return working;
    }

    bool is_settled(const int block) const
    {
      return settled[block] != 0;
    }

    /// What a trial leaves of the balance.
    struct Balance
    {
      const Eigen::VectorXd &residual; ///< of blocks, then of nodes
      const Eigen::VectorXd &scale;    ///< of its norm
      const Eigen::VectorXd &forces;   ///< sum of absolute ones of each block [N]
    };

    /// Settle the islands with a residual of at most @p tolerance times their own forces: neither
    /// changes any more, so that all of them together stay within it. Their springs are marked
    /// (Spring::settled). @return whether any was settled
    bool settle(const Balance &balance, double tolerance, Springs &springs);

    /// Only these blocks, of those at work and ascending, are at work until widen(), whether they
    /// are an island or not.
    void narrow(const std::vector<int> &blocks);

    void widen();

    /// All blocks are at work again.
    void wake(Springs &springs);

  private:
    std::vector<int>    working;
    std::vector<char>   settled; ///< of each block
    std::vector<int>    wide;    ///< at work before narrow()
    std::vector<int>    root;    ///< of each block's island: its first block
    std::vector<double> left;    ///< at the root: squares of residuals less their bounds [N2]
    bool                is_split  = false; ///< root is that of this step
    int                 n_islands = 0;

    int find(int block);

    void split(const Springs &springs);
  };
} // namespace hybrid::dda
