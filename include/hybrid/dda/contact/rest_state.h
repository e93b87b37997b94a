// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/geometry.h>

#include <vector>

namespace hybrid::dda
{
  /// What contact search knows of bodies at rest. Empty at the start.
  struct RestState
  {
    std::vector<Vec2> vertices,
      foundation_nodes; ///< where each block and node was when it last moved [m]
    std::vector<char> settled_vertices, settled_nodes; ///< searched at rest, with nothing new found
  };
} // namespace hybrid::dda
