// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/cavern_check.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace hybrid::scene
{
  namespace
  {
    using Edge = SectionMesh::Edge;

    /// Nodes of a closed boundary of the bedrock, with the rock on the left hand.
    using Wall = std::vector<int>;


    Edge sorted(const Edge &edge)
    {
      return {std::min(edge[0], edge[1]), std::max(edge[0], edge[1])};
    }


    /// Edges of one cell, from the first end to the second with the cell on the left hand, by
    /// their first ends.
    std::multimap<int, int> boundary(const SectionMesh &mesh)
    {
      std::map<Edge, int> count;
      for (const auto &cell : mesh.bedrock_cells)
        for (int i = 0; i < 4; ++i)
          ++count[sorted({cell[i], cell[(i + 1) % 4]})];
      std::multimap<int, int> next;
      for (const auto &cell : mesh.bedrock_cells)
        for (int i = 0; i < 4; ++i)
          if (count.at(sorted({cell[i], cell[(i + 1) % 4]})) == 1)
            next.emplace(cell[i], cell[(i + 1) % 4]);
      return next;
    }


    double signed_area(const SectionMesh &mesh, const Wall &wall)
    {
      double area = 0.;
      for (std::size_t i = 1; i + 1 < wall.size(); ++i)
        area += 0.5 * cross(mesh.nodes[wall[i]] - mesh.nodes[wall[0]],
                            mesh.nodes[wall[i + 1]] - mesh.nodes[wall[0]]);
      return area;
    }


    /// Closed boundaries that go round what is not rock.
    std::vector<Wall> walls_of_caverns(const SectionMesh &mesh)
    {
      std::multimap<int, int> next = boundary(mesh);
      std::vector<Wall>       walls;
      while (!next.empty())
        {
          Wall wall;
          for (auto at = next.begin(); at != next.end(); at = next.find(wall.back()))
            {
              if (wall.empty())
                wall.push_back(at->first);
              wall.push_back(at->second);
              next.erase(at);
              if (wall.back() == wall.front())
                break;
            }
          wall.pop_back(); // the first node again
          if (signed_area(mesh, wall) < 0.)
            walls.push_back(wall);
        }
      return walls;
    }


    std::string extent(const SectionMesh &mesh, const Wall &wall)
    {
      Vec2 low = mesh.nodes[wall.front()], high = low;
      for (const int node : wall)
        {
          low  = low.cwiseMin(mesh.nodes[node]);
          high = high.cwiseMax(mesh.nodes[node]);
        }
      std::ostringstream text;
      text << "x = " << low.x() << " to " << high.x() << " m, y = " << low.y() << " to " << high.y()
           << " m";
      return text.str();
    }


    /// Edges of the wall that are in the set.
    int count_edges(const Wall &wall, const std::set<Edge> &edges)
    {
      int n = 0;
      for (std::size_t i = 0; i < wall.size(); ++i)
        n += static_cast<int>(edges.count(sorted({wall[i], wall[(i + 1) % wall.size()]})));
      return n;
    }
  } // namespace


  void check_caverns(const SectionMesh &mesh, const SceneParameters &scene)
  {
    std::set<Edge> on_lines, on_surface;
    for (const auto &[name, edges] : mesh.lines)
      for (const Edge &edge : edges)
        {
          on_lines.insert(sorted(edge));
          if (name == "ground" || name == "sliding_surface")
            on_surface.insert(sorted(edge));
        }
    const bool needs_one_path = scene.has_blocks() && !scene.has_bedrock_blocks();
    for (const Wall &wall : walls_of_caverns(mesh))
      {
        const int n = static_cast<int>(wall.size());
        if (needs_one_path &&
            (count_edges(wall, on_surface) == n || count_edges(wall, on_lines) == 0))
          throw InputError(
            "The bedrock has a closed cavern, " + extent(mesh, wall) +
            "; the surface of finite elements below blocks must be one path from side to side, "
            "without a hole below it. Leave the cavern out, fill it with a region of bedrock of "
            "its own (with a soft material), open it to the ground, or set Model/Blocks = none.");
        if (count_edges(wall, on_lines) == 0)
          throw InputError("The bedrock has a closed cavern, " + extent(mesh, wall) +
                           ", whose wall is on none of the lines base, left, right, ground, "
                           "sliding_surface; a free wall belongs to the curve group 'ground'.");
      }
  }
} // namespace hybrid::scene
