// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/level_layers.h>

#include <cmath>
#include <map>
#include <utility>

namespace hybrid::scene
{
  bool has_level_layers(const SectionMesh &mesh)
  {
    const double                       largest_slope = std::tan(M_PI / 180.);
    std::map<std::pair<int, int>, int> region; // of an edge, the cell to its left
    for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
      for (std::size_t i = 0; i < 4; ++i)
        region[{mesh.bedrock_cells[c][i], mesh.bedrock_cells[c][(i + 1) % 4]}] =
          mesh.bedrock_region[c];
    for (const auto &[edge, own] : region)
      {
        const auto other = region.find({edge.second, edge.first});
        if (other == region.end() || other->second == own)
          continue;
        const Vec2 along = mesh.nodes[edge.second] - mesh.nodes[edge.first];
        if (std::abs(along.y()) > largest_slope * std::abs(along.x()))
          return false;
      }
    return true;
  }
} // namespace hybrid::scene
