// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/rock_mesh.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

namespace hybrid::continuum
{
  namespace
  {
    using Edge      = std::array<int, 2>;
    using EdgeCells = std::map<Edge, std::vector<int>>;

    Edge undirected(const int a, const int b)
    {
      return {std::min(a, b), std::max(a, b)};
    }

    EdgeCells cells_of_edges(const std::vector<std::array<int, 4>> &cells)
    {
      EdgeCells result;
      for (std::size_t c = 0; c < cells.size(); ++c)
        for (int i = 0; i < 4; ++i)
          result[undirected(cells[c][i], cells[c][(i + 1) % 4])].push_back(static_cast<int>(c));
      return result;
    }

    /// Edges inside the rock, with the number of the plane they belong to.
    std::map<Edge, int> plane_edges(const scene::SectionMesh       &mesh,
                                    const std::vector<std::string> &planes,
                                    const EdgeCells                &edge_cells)
    {
      std::map<Edge, int> result;
      for (std::size_t plane = 0; plane < planes.size(); ++plane)
        {
          const std::string &name = planes[plane];
          const auto         line = mesh.lines.find(name);
          if (line == mesh.lines.end())
            throw InputError("Bedding planes/Names: the mesh has no line named '" + name + "'.");
          bool inside = false;
          for (const auto &edge : line->second)
            {
              const auto found = edge_cells.find(undirected(edge[0], edge[1]));
              if (found != edge_cells.end() && found->second.size() == 2)
                {
                  result.emplace(found->first, static_cast<int>(plane));
                  inside = true;
                }
            }
          if (!inside)
            throw InputError("Bedding planes/Names: line '" + name +
                             "' has no edge between two bedrock cells.");
        }
      return result;
    }

    /// Sets of cells around @p node that are connected without crossing a plane, in order of cell
    /// index.
    std::vector<std::vector<int>> sides_of_node(const int               node,
                                                const std::vector<int> &around,
                                                const RockMesh         &rock,
                                                const EdgeCells        &edge_cells,
                                                const std::set<Edge>   &planes)
    {
      std::vector<std::vector<int>> sides;
      std::set<int>                 seen;
      for (const int start : around)
        {
          if (!seen.insert(start).second)
            continue;
          std::vector<int> side = {start};
          for (std::size_t k = 0; k < side.size(); ++k)
            for (int i = 0; i < 4; ++i)
              {
                const auto &cell = rock.cells[side[k]];
                const Edge  edge = undirected(cell[i], cell[(i + 1) % 4]);
                if ((edge[0] != node && edge[1] != node) || planes.count(edge) > 0)
                  continue;
                for (const int neighbour : edge_cells.at(edge))
                  if (seen.insert(neighbour).second)
                    side.push_back(neighbour);
              }
          sides.push_back(side);
        }
      return sides;
    }

    void check_orientation(const scene::SectionMesh &mesh)
    {
      for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
        {
          const auto &cell = mesh.bedrock_cells[c];
          for (int i = 0; i < 4; ++i)
            {
              const Vec2 &p = mesh.nodes[cell[i]];
              if (cross(mesh.nodes[cell[(i + 1) % 4]] - p, mesh.nodes[cell[(i + 3) % 4]] - p) <= 0.)
                throw InputError("Mesh: bedrock cell " + std::to_string(c) + " near (" +
                                 std::to_string(p.x()) + ", " + std::to_string(p.y()) +
                                 ") is inverted or has an angle of 180 degrees or more.");
            }
        }
    }

    /// Renumber the nodes that cells use by 0, 1, ...; @p rock holds section-mesh indices before.
    void keep_used_nodes(const scene::SectionMesh &mesh, RockMesh &rock)
    {
      std::vector<int> index(mesh.nodes.size(), -1);
      for (auto &cell : rock.cells)
        for (int &node : cell)
          {
            if (index[node] < 0)
              {
                index[node] = static_cast<int>(rock.nodes.size());
                rock.nodes.push_back(mesh.nodes[node]);
                rock.origin.push_back(node);
              }
            node = index[node];
          }
    }

    /// The face of @p cell between the nodes whose origins are the ends of @p edge.
    RockFace face_of_cell(const RockMesh &rock, const int cell, const Edge &edge)
    {
      const auto &nodes = rock.cells[cell];
      for (int i = 0; i < 4; ++i)
        {
          const int a = nodes[i], b = nodes[(i + 1) % 4];
          if (undirected(rock.origin[a], rock.origin[b]) == edge)
            return {cell, a, b};
        }
      return {-1, -1, -1};
    }
  } // namespace


  RockMesh split_bedding_planes(const scene::SectionMesh       &mesh,
                                const std::vector<std::string> &planes)
  {
    check_orientation(mesh);
    const EdgeCells           section_edges  = cells_of_edges(mesh.bedrock_cells);
    const std::map<Edge, int> section_planes = plane_edges(mesh, planes, section_edges);

    RockMesh rock;
    rock.cells = mesh.bedrock_cells;
    keep_used_nodes(mesh, rock);

    const RockMesh     whole      = rock;
    const EdgeCells    edge_cells = cells_of_edges(whole.cells);
    std::map<int, int> rock_node;
    for (std::size_t n = 0; n < rock.origin.size(); ++n)
      rock_node[rock.origin[n]] = static_cast<int>(n);
    std::set<Edge> cut;
    for (const auto &[edge, plane] : section_planes)
      cut.insert(undirected(rock_node.at(edge[0]), rock_node.at(edge[1])));

    std::map<int, std::vector<int>> around;
    for (const auto &edge : cut)
      {
        around[edge[0]];
        around[edge[1]];
      }
    for (std::size_t c = 0; c < whole.cells.size(); ++c)
      for (const int node : whole.cells[c])
        if (const auto found = around.find(node); found != around.end())
          found->second.push_back(static_cast<int>(c));

    for (const auto &[node, cells] : around)
      {
        const auto sides = sides_of_node(node, cells, whole, edge_cells, cut);
        for (std::size_t s = 1; s < sides.size(); ++s)
          {
            const int copy = static_cast<int>(rock.nodes.size());
            rock.nodes.push_back(whole.nodes[node]);
            rock.origin.push_back(whole.origin[node]);
            for (const int cell : sides[s])
              std::replace(rock.cells[cell].begin(), rock.cells[cell].end(), node, copy);
          }
      }

    for (const auto &[edge, plane] : section_planes)
      {
        const auto    &cells  = section_edges.at(edge);
        const RockFace first  = face_of_cell(rock, cells[0], edge);
        RockFace       second = face_of_cell(rock, cells[1], edge);
        std::swap(second.a, second.b);
        if (first.a != second.a || first.b != second.b)
          rock.joints.push_back({first, second, plane});
      }
    return rock;
  }


  std::vector<RockFace> boundary_faces(const RockMesh                              &rock,
                                       const std::vector<scene::SectionMesh::Edge> &line)
  {
    EdgeCells by_origin;
    for (std::size_t c = 0; c < rock.cells.size(); ++c)
      for (int i = 0; i < 4; ++i)
        by_origin[undirected(rock.origin[rock.cells[c][i]],
                             rock.origin[rock.cells[c][(i + 1) % 4]])]
          .push_back(static_cast<int>(c));

    std::vector<RockFace> faces;
    for (const auto &edge : line)
      {
        const auto found = by_origin.find(undirected(edge[0], edge[1]));
        if (found != by_origin.end() && found->second.size() == 1)
          faces.push_back(face_of_cell(rock, found->second[0], found->first));
      }
    return faces;
  }


  namespace
  {
    /// Names a place of the smaller part: of the path, or of what it does not reach.
    std::string not_one_path(const RockMesh              &rock,
                             const std::vector<RockFace> &faces,
                             const std::vector<RockFace> &path)
    {
      std::set<int> reached;
      for (const RockFace &face : path)
        reached.insert(rock.origin[face.b]);
      const bool         is_path_smaller = !path.empty() && 2 * path.size() < faces.size();
      const auto         part = std::find_if(faces.begin(), faces.end(), [&](const RockFace &face) {
        return (reached.count(rock.origin[face.b]) > 0) == is_path_smaller;
      });
      const Vec2         x    = rock.nodes[part->b];
      const auto         count = is_path_smaller ? path.size() : faces.size() - path.size();
      std::ostringstream text;
      text << "Mesh: the surface of finite elements below blocks, lines 'ground' and "
              "'sliding_surface', must be one path from side to side; "
           << count << " of its " << faces.size() << " edges are apart from the others, one at ("
           << x.x() << ", " << x.y()
           << ") m. Fill an opening at a side of the section (a gallery) with a region of bedrock "
              "of its own (with a soft material), or set Model/Blocks = none.";
      return text.str();
    }
  } // namespace


  std::vector<RockFace> surface_chain(const RockMesh &rock, const std::vector<RockFace> &faces)
  {
    // Counter-clockwise order runs from right to left on top: a face starts at its b.
    std::map<int, int> face_at_start;
    std::set<int>      ends;
    for (std::size_t f = 0; f < faces.size(); ++f)
      {
        face_at_start[rock.origin[faces[f].b]] = static_cast<int>(f);
        ends.insert(rock.origin[faces[f].a]);
      }

    std::vector<RockFace> chain;
    for (const auto &face : faces)
      if (ends.count(rock.origin[face.b]) == 0 && chain.empty())
        for (int at = rock.origin[face.b]; face_at_start.count(at) > 0;)
          {
            chain.push_back(faces[face_at_start[at]]);
            at = rock.origin[chain.back().a];
          }
    if (chain.size() != faces.size())
      throw InputError(not_one_path(rock, faces, chain));
    return chain;
  }
} // namespace hybrid::continuum
