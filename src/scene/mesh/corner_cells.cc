// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/corner_cells.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace hybrid::scene
{
  namespace
  {
    constexpr double least_turn   = M_PI / 18.;    ///< of a corner that matters [rad]
    constexpr double same_place   = 1e-6;          ///< of an edge: two corners are one [-]
    const double     least_growth = std::sqrt(2.); ///< of an edge in a mesh twice as coarse [-]



    /// Halves the cells at one node of a mesh towards it.
    class CornerCells
    {
    public:
      CornerCells(SectionMesh &of_section, const int node)
        : mesh(of_section)
        , corner(node)
      {}

      void halve()
      {
        const std::size_t n_cells = mesh.bedrock_cells.size();
        for (std::size_t cell = 0; cell < n_cells; ++cell)
          {
            const auto &nodes = mesh.bedrock_cells[cell];
            const auto  found = std::find(nodes.begin(), nodes.end(), corner);
            if (found != nodes.end())
              split(cell, found - nodes.begin());
          }
        for (auto &[name, edges] : mesh.lines)
          split(edges);
      }

    private:
      SectionMesh       &mesh;
      const int          corner;
      std::map<int, int> middle; ///< of the edge from the corner to a node

      int add(const Vec2 &position)
      {
        mesh.nodes.push_back(position);
        return static_cast<int>(mesh.nodes.size()) - 1;
      }

      int middle_to(const int node)
      {
        const auto known = middle.find(node);
        if (known != middle.end())
          return known->second;
        return middle[node] = add(0.5 * (mesh.nodes[corner] + mesh.nodes[node]));
      }

      /// A cell whose node @p first is the corner.
      void split(const std::size_t cell, const std::size_t first)
      {
        const auto nodes = mesh.bedrock_cells[cell];
        const int  a = nodes[(first + 1) % 4], c = nodes[(first + 2) % 4],
                  b    = nodes[(first + 3) % 4];
        const int to_a = middle_to(a), to_b = middle_to(b);
        const int centre =
          add(0.25 * (mesh.nodes[corner] + mesh.nodes[a] + mesh.nodes[b] + mesh.nodes[c]));
        mesh.bedrock_cells[cell] = {{corner, to_a, centre, to_b}};
        mesh.bedrock_cells.push_back({{to_a, a, c, centre}});
        mesh.bedrock_cells.push_back({{centre, c, b, to_b}});
        for (std::vector<int> *number : {&mesh.bedrock_region, &mesh.bedrock_surface})
          if (cell < number->size())
            number->insert(number->end(), 2, (*number)[cell]);
      }

      /// Those of a line that end at the corner.
      void split(std::vector<SectionMesh::Edge> &edges) const
      {
        std::vector<SectionMesh::Edge> result;
        for (const SectionMesh::Edge &edge : edges)
          {
            const auto found = edge[0] == corner   ? middle.find(edge[1])
                               : edge[1] == corner ? middle.find(edge[0])
                                                   : middle.end();
            if (found == middle.end())
              result.push_back(edge);
            else
              {
                result.push_back({{edge[0], found->second}});
                result.push_back({{found->second, edge[1]}});
              }
          }
        edges = std::move(result);
      }
    };
  } // namespace



  std::vector<ReentrantCorner> corners_of_bedrock(const SectionMesh &mesh)
  {
    std::set<int> of_blocks;
    for (const auto &block : mesh.blocks)
      of_blocks.insert(block.begin(), block.end());
    std::vector<ReentrantCorner> result;
    for (const ReentrantCorner &corner : reentrant_corners(mesh, least_turn))
      if (of_blocks.count(corner.node) == 0)
        result.push_back(corner);
    return result;
  }



  void halve_corner_cells(SectionMesh &mesh, const int times)
  {
    if (times == 0)
      return;
    const std::vector<ReentrantCorner> corners = corners_of_bedrock(mesh);
    for (int i = 0; i < times; ++i)
      for (const ReentrantCorner &corner : corners)
        CornerCells(mesh, corner.node).halve();
  }



  bool keeps_corner_cells(const std::vector<ReentrantCorner> &corners,
                          const std::vector<ReentrantCorner> &coarser)
  {
    for (const ReentrantCorner &corner : corners)
      for (const ReentrantCorner &other : coarser)
        if ((other.position - corner.position).norm() < same_place * corner.edge[0] &&
            (other.edge[0] < least_growth * corner.edge[0] ||
             other.edge[1] < least_growth * corner.edge[1]))
          return true;
    return false;
  }
} // namespace hybrid::scene
