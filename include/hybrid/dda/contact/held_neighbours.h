// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

namespace hybrid::dda
{
  /**
   * Blocks that joints hold beside each other although no joint need lie between them: they share
   * nodes of the mesh, and around every shared node a chain of bonded pairs leads from one to the
   * other. Loose blocks on a belt share nodes too, but nothing holds them apart.
   *
   * @param outlines nodes of each block's corners. @param bonded pairs of blocks with a joint
   * between them, the lower first, sorted.
   * @return per block the others, ascending. The relation is symmetric.
   */
  std::vector<std::vector<int>> held_neighbours(const std::vector<std::vector<int>>    &outlines,
                                                const std::vector<std::pair<int, int>> &bonded);
} // namespace hybrid::dda
