// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/bedrock/layers_bedrock.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace hybrid::scene
{
  namespace
  {
    using Edge = std::pair<int, int>;

    Edge sorted(const int a, const int b)
    {
      return {std::min(a, b), std::max(a, b)};
    }



    std::set<Edge> edges_of(const SectionMesh &mesh, const std::vector<std::string> &lines)
    {
      std::set<Edge> edges;
      for (const std::string &name : lines)
        {
          const auto line = mesh.lines.find(name);
          if (line != mesh.lines.end())
            for (const auto &edge : line->second)
              edges.insert(sorted(edge[0], edge[1]));
        }
      return edges;
    }



    /// Boundary loop of the cells of one surface, counter-clockwise.
    std::vector<int> outline_of(const SectionMesh &mesh, const std::vector<int> &cells)
    {
      std::set<Edge> directed;
      for (const int c : cells)
        for (int i = 0; i < 4; ++i)
          directed.insert({mesh.bedrock_cells[c][i], mesh.bedrock_cells[c][(i + 1) % 4]});
      std::map<int, int> next;
      std::size_t        edges = 0;
      for (const Edge &e : directed)
        if (directed.count({e.second, e.first}) == 0)
          {
            next[e.first] = e.second;
            ++edges;
          }
      std::vector<int> loop{next.begin()->first};
      for (int node = next.at(loop[0]); node != loop[0] && loop.size() <= edges;
           node     = next.at(node))
        loop.push_back(node);
      if (loop.size() != edges)
        {
          const Vec2 &x = mesh.nodes[loop[0]];
          throw InputError(
            "Model/Bedrock = layers: the layer at (" + std::to_string(x.x()) + ", " +
            std::to_string(x.y()) +
            ") m is not bounded by one closed line; a layer must be a surface without "
            "holes that does not touch itself");
        }
      return loop;
    }



    /// Nodes of the upper boundary of the lowest layer, left to right.
    std::vector<int> upper_boundary(const SectionMesh &mesh, const std::vector<int> &loop)
    {
      const std::set<Edge> outside  = edges_of(mesh, {"base", "left", "right"});
      const int            n        = static_cast<int>(loop.size());
      const auto           is_above = [&](const int k) {
        return outside.count(sorted(loop[k % n], loop[(k + 1) % n])) == 0;
      };
      std::vector<int> nodes;
      for (int k = 0; k < n; ++k)
        if (is_above(k) && !is_above(k + n - 1))
          for (int j = k; j <= k + n && (nodes.empty() || is_above(j - 1)); ++j)
            nodes.push_back(loop[j % n]);
      std::reverse(nodes.begin(), nodes.end());
      return nodes;
    }



    /// A plane with one surface of the geometry on both sides cuts no layer off.
    void check_planes(const SectionMesh &mesh, const std::vector<std::string> &planes)
    {
      std::map<Edge, std::vector<int>> surfaces; // on the sides of each edge
      for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
        for (int i = 0; i < 4; ++i)
          surfaces[sorted(mesh.bedrock_cells[c][i], mesh.bedrock_cells[c][(i + 1) % 4])].push_back(
            mesh.bedrock_surface[c]);
      for (const std::string &plane : planes)
        for (const auto &edge : mesh.lines.at(plane))
          {
            const auto &sides = surfaces.at(sorted(edge[0], edge[1]));
            if (sides.front() != sides.back())
              continue;
            const Vec2 x = 0.5 * (mesh.nodes[edge[0]] + mesh.nodes[edge[1]]);
            throw InputError("Model/Bedrock = layers: " + plane +
                             " does not divide the bedrock at (" + std::to_string(x.x()) + ", " +
                             std::to_string(x.y()) +
                             ") m, where both of its sides belong to one surface of the mesh; "
                             "continue it to the sides and draw one Plane Surface per layer, as "
                             "meshes/layers.geo does, or take Model/Bedrock = continuum or "
                             "triangles");
          }
    }



    BedrockBlocks layers(const SectionMesh &mesh, const SceneParameters &scene)
    {
      check_planes(mesh, scene.bedding.names);
      std::map<int, std::vector<int>> cells_of;
      for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
        cells_of[mesh.bedrock_surface[c]].push_back(static_cast<int>(c));
      const std::set<Edge> base = edges_of(mesh, {"base"});
      BedrockBlocks        blocks;
      for (const auto &layer : cells_of)
        {
          const std::vector<int> loop   = outline_of(mesh, layer.second);
          const int              region = mesh.bedrock_region[layer.second.front()];
          for (const int c : layer.second)
            if (mesh.bedrock_region[c] != region)
              {
                const Vec2 &x = mesh.nodes[mesh.bedrock_cells[c][0]];
                throw InputError("Model/Bedrock = layers: the layer at (" + std::to_string(x.x()) +
                                 ", " + std::to_string(x.y()) +
                                 ") m lies in two regions of the mesh; it must lie in one");
              }
          std::size_t on_foundation = 0;
          for (std::size_t k = 0; k < loop.size(); ++k)
            on_foundation += base.count(sorted(loop[k], loop[(k + 1) % loop.size()]));
          if (on_foundation == 0)
            {
              blocks.outlines.push_back(loop);
              blocks.region.push_back(region);
            }
          else if (on_foundation < base.size())
            {
              const Vec2 &x = mesh.nodes[loop[0]];
              throw InputError("Model/Bedrock = layers: the layer at (" + std::to_string(x.x()) +
                               ", " + std::to_string(x.y()) +
                               ") m has only a part of the line base; each layer must be one "
                               "surface of the mesh from side to side");
            }
          else
            blocks.foundation = upper_boundary(mesh, loop);
        }
      return blocks;
    }
  } // namespace



  BedrockModel layers_bedrock()
  {
    BedrockModel bedrock{"layers", "layers on the one that moves"};
    bedrock.cut          = layers;
    bedrock.needs_planes = true;
    bedrock.base_words   = "below the lowest layer, which moves with the motion";
    return bedrock;
  }
} // namespace hybrid::scene
