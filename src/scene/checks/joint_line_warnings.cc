// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/joint_line_warnings.h>
#include <hybrid/scene/mesh/joint_lines.h>
#include <hybrid/scene/parameters/parameter_values.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace hybrid::scene
{
  namespace
  {
    using Edge = SectionMesh::Edge;

    constexpr double on_line = 1e-3; ///< distance over length, up to which edges lie on each other

    /// An edge of a block, in its sense.
    struct BlockEdge
    {
      int  block;
      Edge nodes;
    };


    Edge in_order(const Edge &edge)
    {
      return {std::min(edge[0], edge[1]), std::max(edge[0], edge[1])};
    }


    /// They face each other and lie on each other along a part of their lengths.
    bool lie_together(const SectionMesh &mesh, const Edge &a, const Edge &b)
    {
      const Vec2   first = mesh.nodes[a[0]], way = mesh.nodes[a[1]] - first;
      const double length = way.norm();
      const Vec2   along  = way / length, across(-along.y(), along.x());
      const Vec2   p = mesh.nodes[b[0]] - first, q = mesh.nodes[b[1]] - first;
      const double from = std::max(0., along.dot(q)), to = std::min(length, along.dot(p));
      return std::abs(across.dot(p)) <= on_line * length &&
             std::abs(across.dot(q)) <= on_line * length && to - from > on_line * length;
    }


    std::string place_text(const SectionMesh &mesh, const Edge &edge)
    {
      const Vec2 middle = 0.5 * (mesh.nodes[edge[0]] + mesh.nodes[edge[1]]);
      return "(" + number_text(middle.x()) + ", " + number_text(middle.y()) + ")";
    }


    /// Edges of one kind, of one line.
    struct Count
    {
      int  edges = 0;
      Edge first{};

      void add(const Edge &edge)
      {
        if (edges++ == 0)
          first = edge;
      }
    };


    std::string edges_text(const Count &count, const std::size_t all)
    {
      return std::to_string(count.edges) + " of its " + std::to_string(all) +
             (all == 1 ? " edge" : " edges");
    }
  } // namespace


  std::vector<std::string> joint_line_warnings(const SectionMesh     &mesh,
                                               const SceneParameters &scene)
  {
    std::vector<BlockEdge>              edges;
    std::map<Edge, std::vector<size_t>> at; // by nodes, ascending
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
      for (std::size_t i = 0; i < mesh.blocks[b].size(); ++i)
        {
          const auto &block = mesh.blocks[b];
          edges.push_back({static_cast<int>(b), {block[i], block[(i + 1) % block.size()]}});
          at[in_order(edges.back().nodes)].push_back(edges.size() - 1);
        }
    const JointLines         named(mesh);
    std::vector<std::string> warnings;
    for (const auto &[name, line] : mesh.lines)
      {
        if (!is_joint_line(name) || scene.joint_material(name, false) == nullptr)
          continue;
        Count alone, one_sided;
        for (const Edge &edge : line)
          {
            const auto owners = at.find(in_order(edge));
            if (owners == at.end() || owners->second.size() != 1)
              continue;
            const BlockEdge &mine   = edges[owners->second.front()];
            bool             is_met = false, is_named = true;
            for (const BlockEdge &other : edges)
              if (other.block != mine.block && lie_together(mesh, mine.nodes, other.nodes))
                {
                  is_met                           = true;
                  const std::string *line_of_other = named.of(other.nodes[0], other.nodes[1]);
                  is_named = is_named && line_of_other != nullptr && *line_of_other == name;
                }
            if (!is_met)
              alone.add(edge);
            else if (!is_named)
              one_sided.add(edge);
          }
        if (alone.edges > 0)
          warnings.push_back(
            name + ": no other block lies at " + edges_text(alone, line.size()) +
            ", the first at " + place_text(mesh, alone.first) +
            ": the line does nothing there until another block comes to lie there (on the sliding "
            "surface Blocks/Belt material or the friction of the ground acts)");
        if (one_sided.edges > 0)
          warnings.push_back(
            name + ": at " + edges_text(one_sided, line.size()) + ", the first at " +
            place_text(mesh, one_sided.first) +
            ", the block on the other side has an edge that meets it in part and has not this name: "
            "contacts with that edge have the material of the block; name both");
      }
    return warnings;
  }
} // namespace hybrid::scene
