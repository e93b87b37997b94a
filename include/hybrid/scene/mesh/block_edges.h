// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

#include <set>
#include <utility>

namespace hybrid::scene
{
  /// Edges of all blocks of a mesh, each once: the numbers of their nodes, ascending.
  std::set<std::pair<int, int>> edges_of_blocks(const SectionMesh &mesh);
} // namespace hybrid::scene
