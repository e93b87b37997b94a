// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/reentrant_corner.h>

#include <cmath>
#include <set>
#include <utility>

namespace hybrid::scene
{
  namespace
  {
    using Edges = std::set<std::pair<int, int>>; ///< from node to node, the body to their left



    template <typename Polygon>
    void add_edges(const Polygon &polygon, Edges &edges)
    {
      for (std::size_t i = 0; i < polygon.size(); ++i)
        edges.emplace(polygon[i], polygon[(i + 1) % polygon.size()]);
    }



    /// Those that no other cell or block has.
    Edges outline(const SectionMesh &mesh)
    {
      Edges all, result;
      for (const auto &cell : mesh.bedrock_cells)
        add_edges(cell, all);
      for (const auto &block : mesh.blocks)
        add_edges(block, all);
      for (const auto &[from, to] : all)
        if (all.count({to, from}) == 0)
          result.emplace(from, to);
      return result;
    }
  } // namespace



  std::vector<ReentrantCorner> reentrant_corners(const SectionMesh &mesh, const double least_turn)
  {
    std::vector<ReentrantCorner> result;
    const Edges                  edges = outline(mesh);
    for (const auto &[from, corner] : edges)
      for (auto next = edges.lower_bound({corner, 0}); next != edges.end() && next->first == corner;
           ++next)
        {
          const Vec2   in    = mesh.nodes[corner] - mesh.nodes[from];
          const Vec2   out   = mesh.nodes[next->second] - mesh.nodes[corner];
          const double cross = in.x() * out.y() - in.y() * out.x();
          const double turn  = std::atan2(-cross, in.dot(out));
          if (turn > least_turn)
            result.push_back({corner, mesh.nodes[corner], turn, {in.norm(), out.norm()}});
        }
    return result;
  }



  bool has_reentrant_corner(const SectionMesh &mesh)
  {
    return !reentrant_corners(mesh, M_PI / 180.).empty();
  }
} // namespace hybrid::scene
