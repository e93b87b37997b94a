// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/shared_edge_check.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <vector>

namespace hybrid::scene
{
  namespace
  {
    constexpr double same_line = 1e-6; ///< of an edge's length: a corner that near lies on it


    using Edge = std::array<int, 2>;


    /// Edges that no other block has, by their nodes as the block runs.
    std::vector<Edge> lone_edges(const SectionMesh &mesh)
    {
      std::map<Edge, int> uses;
      for (const auto &block : mesh.blocks)
        for (std::size_t i = 0; i < block.size(); ++i)
          ++uses[{block[i], block[(i + 1) % block.size()]}];
      std::vector<Edge> lone;
      for (const auto &[edge, count] : uses)
        if (uses.count({edge[1], edge[0]}) == 0)
          lone.push_back(edge);
      return lone;
    }


    /// True if the other edge lies along this one, the other way, over some of its length.
    bool lie_along(const SectionMesh &mesh, const Edge &edge, const Edge &other)
    {
      const Vec2  &a       = mesh.nodes[edge[0]];
      const Vec2   along   = mesh.nodes[edge[1]] - a;
      const double squared = along.squaredNorm();
      double       part[2];
      for (int k = 0; k < 2; ++k)
        {
          const Vec2 r = mesh.nodes[other[k]] - a;
          if (std::abs(cross(along, r)) > same_line * squared)
            return false;
          part[k] = along.dot(r) / squared;
        }
      return part[0] > part[1] && std::min(part[0], 1.) - std::max(part[1], 0.) > same_line;
    }
  } // namespace


  std::string partly_shared_edges(const SectionMesh &mesh)
  {
    std::vector<Edge> edges = lone_edges(mesh);
    const auto        left  = [&](const Edge &e) {
      return std::min(mesh.nodes[e[0]].x(), mesh.nodes[e[1]].x());
    };
    const auto right = [&](const Edge &e) {
      return std::max(mesh.nodes[e[0]].x(), mesh.nodes[e[1]].x());
    };
    std::sort(edges.begin(), edges.end(), [&](const Edge &e, const Edge &f) {
      return left(e) < left(f);
    });
    int  count = 0;
    Vec2 where = Vec2::Zero();
    for (std::size_t k = 0; k < edges.size(); ++k)
      for (std::size_t j = k + 1; j < edges.size() && left(edges[j]) <= right(edges[k]); ++j)
        if (lie_along(mesh, edges[k], edges[j]) && count++ == 0)
          where = 0.5 * (mesh.nodes[edges[j][0]] + mesh.nodes[edges[j][1]]);
    if (count == 0)
      return "";
    std::ostringstream text;
    text << "blocks lie along each other with edges that coincide only in part, the first at ("
         << where.x() << ", " << where.y() << ") m";
    if (count > 1)
      text << " and in " << count - 1 << (count == 2 ? " other place" : " other places");
    text
      << ": joints bond whole edges only, so nothing is bonded there; give each edge the corners "
         "of its neighbours (a polygon may have corners of 180 degrees)";
    return text.str();
  }
} // namespace hybrid::scene
