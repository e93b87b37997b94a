// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/joint_lines.h>

#include <algorithm>
#include <sstream>

namespace hybrid::scene
{
  bool is_joint_line(const std::string &name)
  {
    const std::string stem = "joint_";
    return name.rfind(stem, 0) == 0 && name.size() > stem.size();
  }



  JointLines::JointLines(const SectionMesh &mesh)
  {
    for (const auto &[name, edges] : mesh.lines)
      {
        if (!is_joint_line(name))
          continue;
        for (const SectionMesh::Edge &edge : edges)
          {
            const auto [entry, is_new] = line_of.emplace(std::minmax(edge[0], edge[1]), name);
            if (is_new || entry->second == name)
              continue;
            const Vec2         middle = 0.5 * (mesh.nodes[edge[0]] + mesh.nodes[edge[1]]);
            std::ostringstream text;
            text << "The edge at (" << middle.x() << ", " << middle.y() << ") m is on two lines, "
                 << entry->second << " and " << name << ".";
            throw InputError(text.str());
          }
      }
  }



  const std::string *JointLines::of(const int node, const int other) const
  {
    const auto found = line_of.find(std::minmax(node, other));
    return found == line_of.end() ? nullptr : &found->second;
  }
} // namespace hybrid::scene
