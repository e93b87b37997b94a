// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace hybrid::continuum
{
  /**
   * The nodes whose motion the state of a rank holds: first its own, ascending; behind them others
   * that it has to know, of boundaries, joints, loads, the surface below blocks and watched points.
   * A "slot" is a position in this list; vectors of a state hold x and y of each.
   */
  class HeldNodes
  {
  public:
    HeldNodes() = default;

    /// All of @p n, as a single rank holds them.
    explicit HeldNodes(const std::size_t n)
      : n_own(n)
      , has_all(true)
    {}

    /// @param own ascending
    explicit HeldNodes(std::vector<int> own);

    /// Hold these, too; slots of before stay. @param nodes in any order, may be held already
    void add(const std::vector<int> &nodes);

    std::size_t size() const
    {
      return n_own + further.size();
    }

    /// -1: the node is not held.
    int slot(int node) const;

    /// The same of many. @pre they are held
    std::vector<int> slots(const std::vector<int> &nodes) const;

    /// Those that are not this rank's, in the order of their slots.
    const std::vector<int> &others() const
    {
      return further;
    }

  private:
    std::size_t                      n_own   = 0;
    bool                             has_all = false;
    std::vector<int>                 mine; ///< unless it has all
    std::vector<int>                 further;
    std::vector<std::pair<int, int>> slot_of_further; ///< node and slot, by nodes
  };
} // namespace hybrid::continuum
