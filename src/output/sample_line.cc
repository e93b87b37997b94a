// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/sample_line.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/edge_chain.h>
#include <hybrid/scene/nearest_name.h>

#include <algorithm>

namespace hybrid::output
{
  namespace
  {
    /// Connected points.
    using Path = std::vector<Vec2>;


    std::vector<Path> paths_of(const std::string &name, const scene::SectionMesh &mesh)
    {
      const auto line = mesh.lines.find(name);
      if (line == mesh.lines.end() || line->second.empty())
        {
          std::vector<std::string> known;
          std::string              list;
          for (const auto &each : mesh.lines)
            {
              known.push_back(each.first);
              list += (list.empty() ? "" : ", ") + each.first;
            }
          throw InputError(
            "Monitors/Lines: the mesh has no line named '" + name + "'" +
            scene::suggestion(name, known) +
            (known.empty() ? "; it has no named lines, give its points: '" + name + ": x, y, x, y'"
                           : "; it has " + list));
        }
      std::vector<Path> paths;
      int               last = -1;
      for (const auto &edge : scene::chain_edges(line->second, mesh.nodes, name))
        {
          if (edge[0] != last)
            paths.push_back({mesh.nodes[edge[0]]});
          paths.back().push_back(mesh.nodes[last = edge[1]]);
        }
      return paths;
    }


    double length_of(const Path &path)
    {
      double length = 0.;
      for (std::size_t k = 0; k + 1 < path.size(); ++k)
        length += (path[k + 1] - path[k]).norm();
      return length;
    }


    /// Add the point at a distance from the start of the path.
    void add_point(const Path &path, double at, const double gap, SampleLine &line)
    {
      double before = 0.;
      for (std::size_t k = 0; k + 1 < path.size(); ++k)
        {
          const Vec2   along  = path[k + 1] - path[k];
          const double length = along.norm();
          if (at > length && k + 2 < path.size())
            {
              at -= length;
              before += length;
              continue;
            }
          const double fraction = std::min(1., at / length);
          line.points.push_back(fraction == 1. ? path[k + 1] : Vec2(path[k] + fraction * along));
          line.tangents.push_back(along / length);
          line.distance.push_back(gap + before + fraction * length);
          return;
        }
    }


    void add_nodes(const Path &path, const double before, SampleLine &line)
    {
      double at = before;
      for (std::size_t k = 0; k < path.size(); ++k)
        {
          const std::size_t edge = std::min(k, path.size() - 2);
          line.points.push_back(path[k]);
          line.tangents.push_back((path[edge + 1] - path[edge]).normalized());
          line.distance.push_back(at);
          if (k + 1 < path.size())
            at += (path[k + 1] - path[k]).norm();
        }
    }


    /// Points equally far apart, the first and the last at the ends; gaps between paths do not
    /// count.
    void add_equal_points(const std::vector<Path> &paths, const int n, SampleLine &line)
    {
      double total = 0.;
      for (const Path &path : paths)
        total += length_of(path);
      for (int k = 0; k < n; ++k)
        {
          double      at = n > 1 ? total * k / (n - 1) : 0.5 * total, before = 0.;
          std::size_t p = 0;
          for (; p + 1 < paths.size() && at > length_of(paths[p]); ++p)
            {
              at -= length_of(paths[p]);
              before += length_of(paths[p]) + (paths[p + 1].front() - paths[p].back()).norm();
            }
          add_point(paths[p], at, before, line);
        }
    }


    bool has_two_sides(const std::string &name, const scene::SceneParameters &scene)
    {
      const auto &planes = scene.bedding.names;
      if (name == "sliding_surface")
        return scene.blocks.enabled;
      return scene.bedrock.has_cells() &&
             std::find(planes.begin(), planes.end(), name) != planes.end();
    }
  } // namespace



  std::vector<SampleLine> sample_lines(const scene::SceneParameters &scene,
                                       const scene::SectionMesh     &mesh)
  {
    std::vector<SampleLine> lines;
    for (const scene::MonitorLine &given : scene.monitors.lines)
      {
        const bool              of_mesh = given.points.empty();
        const std::vector<Path> paths =
          of_mesh ? paths_of(given.name, mesh) : std::vector<Path>{given.points};
        SampleLine line;
        line.name       = given.name;
        line.is_of_mesh = of_mesh;
        line.has_sides  = of_mesh && has_two_sides(given.name, scene);
        double before   = 0.;
        if (scene.monitors.line_points > 0)
          add_equal_points(paths, scene.monitors.line_points, line);
        else
          for (std::size_t p = 0; p < paths.size(); ++p)
            {
              add_nodes(paths[p], before, line);
              if (p + 1 < paths.size())
                before += length_of(paths[p]) + (paths[p + 1].front() - paths[p].back()).norm();
            }
        lines.push_back(std::move(line));
      }
    return lines;
  }



  std::vector<LineSide> add_line_probes(const SampleLine &line, Probes &probes)
  {
    const auto name = [&](const std::size_t k) {
      return line.name + " point " + std::to_string(k);
    };
    if (!line.has_sides)
      {
        LineSide on{"on", {}};
        for (std::size_t k = 0; k < line.points.size(); ++k)
          {
            // A line of the mesh belongs to what it bounds, not to a block whose corner stands on
            // it.
            int probe = line.is_of_mesh ? probes.add_beside(line.points[k], -line.tangents[k]) : -1;
            if (line.is_of_mesh && probe < 0)
              probe = probes.add_beside(line.points[k], line.tangents[k]);
            on.probes.push_back(probe >= 0 ? probe : probes.add(line.points[k], name(k)));
          }
        return {on};
      }
    LineSide above{"above", {}}, below{"below", {}};
    for (std::size_t k = 0; k < line.points.size(); ++k)
      {
        int left  = probes.add_beside(line.points[k], line.tangents[k]),
            right = probes.add_beside(line.points[k], -line.tangents[k]);
        if (left < 0 && right < 0)
          left = probes.add(line.points[k], name(k));
        above.probes.push_back(left >= 0 ? left : right);
        below.probes.push_back(right >= 0 ? right : left);
      }
    return {above, below};
  }
} // namespace hybrid::output
