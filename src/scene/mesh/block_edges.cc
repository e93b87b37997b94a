// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/block_edges.h>

#include <algorithm>

namespace hybrid::scene
{
  std::set<std::pair<int, int>> edges_of_blocks(const SectionMesh &mesh)
  {
    std::set<std::pair<int, int>> edges;
    for (const auto &block : mesh.blocks)
      for (std::size_t i = 0; i < block.size(); ++i)
        edges.insert(std::minmax(block[i], block[(i + 1) % block.size()]));
    return edges;
  }
} // namespace hybrid::scene
