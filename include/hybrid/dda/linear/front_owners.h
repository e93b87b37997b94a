// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/front_tree.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Which process eliminates a front: whole subtrees go to one process each, and the fronts above
   * them are eliminated by all (proportional mapping, Pothen and Sun 1993, with the top
   * duplicated). As blocks are ordered by nested dissection, a subtree is a region of the mass.
   */
  struct FrontOwners
  {
    static constexpr int all = -1;

    FrontOwners() = default;

    /// The mapping with the least products on the process that has most.
    FrontOwners(const FrontTree &tree, int n_processes);

    /// The front is one of a process, and its parent one of all.
    bool is_handed_over(const FrontTree &tree, const int f) const
    {
      return of[f] != all && tree.parent[f] >= 0 && of[tree.parent[f]] == all;
    }

    int              processes = 1;
    std::vector<int> of;           ///< each front
    double           largest = 0.; ///< products of the process that has most, those of all with it
  };
} // namespace hybrid::dda
