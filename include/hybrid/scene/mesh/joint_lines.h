// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

#include <map>
#include <string>
#include <utility>

namespace hybrid::scene
{
  /// True of "joint_<suffix>": edges of blocks whose joints may have a material of their own.
  bool is_joint_line(const std::string &name);


  /// The lines joint_<suffix> of a mesh, by their edges.
  class JointLines
  {
  public:
    /// @throws InputError if an edge is on two of them.
    explicit JointLines(const SectionMesh &mesh);

    /// Name of the line that the edge between two nodes is on; nullptr: of none.
    const std::string *of(int node, int other) const;

  private:
    std::map<std::pair<int, int>, std::string> line_of; ///< by nodes, ascending
  };
} // namespace hybrid::scene
