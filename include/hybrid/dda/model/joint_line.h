// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hybrid::dda
{
  /// Edges that two blocks of the mass share on a line joint_<suffix> of the mesh, bonded or loose.
  struct JointLine
  {
    /// The same edge seen from its two blocks: the first vertices of both (Geometry::vertices).
    struct Edge
    {
      int vertex;
      int twin;
    };

    std::string       name;
    std::vector<Edge> edges;
  };
} // namespace hybrid::dda
