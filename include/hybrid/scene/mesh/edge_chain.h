// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * The same edges, sorted and turned so that each connected path is consecutive and runs
   * from its end with the smaller x (at equal x, the smaller y); paths in the order of their
   * first nodes by the same rule. A closed path starts at its smallest node.
   *
   * @throws InputError naming the line @p name where three edges meet in a node, or an edge is
   * listed twice.
   */
  std::vector<SectionMesh::Edge> chain_edges(const std::vector<SectionMesh::Edge> &edges,
                                             const std::vector<Vec2>              &nodes,
                                             const std::string                    &name);
} // namespace hybrid::scene
