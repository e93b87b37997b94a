// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/output/formatted.h>
#include <hybrid/output/watched_points.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace hybrid::output
{
  namespace
  {
    constexpr const char *base_name = "base";



    Vec2 middle_of(const std::vector<Vec2> &points)
    {
      Vec2 sum = Vec2::Zero();
      for (const Vec2 &x : points)
        sum += x;
      return points.empty() ? sum : Vec2(sum / static_cast<double>(points.size()));
    }



    Vec2 nearest_to(const Vec2 &x, const std::vector<Vec2> &points)
    {
      return *std::min_element(points.begin(), points.end(), [&](const Vec2 &a, const Vec2 &b) {
        return (a - x).squaredNorm() < (b - x).squaredNorm();
      });
    }



    /// Up to so many that lie far from each other.
    std::vector<Vec2> spread(const std::vector<Vec2> &points, const int most)
    {
      std::vector<Vec2>   result;
      std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
      Vec2                next  = points.empty() ? Vec2() : nearest_to(middle_of(points), points);
      const auto          count = std::min(static_cast<std::size_t>(most), points.size());
      while (result.size() < count)
        {
          result.push_back(next);
          for (std::size_t i = 0; i < points.size(); ++i)
            distance[i] = std::min(distance[i], (points[i] - next).squaredNorm());
          const auto farthest = std::max_element(distance.begin(), distance.end());
          if (*farthest == 0.)
            break;
          next = points[farthest - distance.begin()];
        }
      return result;
    }



    /// Of the blocks of the mass that they lie in.
    std::vector<Vec2> centroids(const dda::Model &blocks)
    {
      std::vector<Vec2>    result;
      const dda::Geometry &g = blocks.initial;
      for (int b = 0; b < blocks.n_mass(); ++b)
        {
          const Vec2 *outline = &g.vertices[g.offset[b]];
          const int   n       = g.offset[b + 1] - g.offset[b];
          const Vec2  x       = dda::polygon_moments(outline, n).centroid;
          if (dda::contains(outline, n, x))
            result.push_back(x);
        }
      return result;
    }



    std::set<int> nodes_of_lines(const scene::SectionMesh                 &mesh,
                                 const std::initializer_list<const char *> names)
    {
      std::set<int> nodes;
      for (const char *name : names)
        {
          const auto line = mesh.lines.find(name);
          if (line != mesh.lines.end())
            for (const auto &edge : line->second)
              nodes.insert(edge.begin(), edge.end());
        }
      return nodes;
    }



    /// Middles of the cells of the bedrock that touch its surface.
    std::vector<Vec2> middles_at_surface(const scene::SectionMesh &mesh)
    {
      const std::set<int> surface = nodes_of_lines(mesh, {"ground", "sliding_surface"});
      std::vector<Vec2>   result;
      for (const auto &cell : mesh.bedrock_cells)
        {
          const bool touches = std::any_of(cell.begin(), cell.end(), [&](const int node) {
            return surface.count(node) > 0;
          });
          Vec2       sum     = Vec2::Zero();
          for (const int node : cell)
            sum += mesh.nodes[node];
          if (touches)
            result.emplace_back(0.25 * sum);
        }
      return result;
    }



    /// Of the base line; without one of the rigid base, below its lowest node by the length of
    /// this surface. @return none: nothing is below.
    std::vector<Vec2> base_point(const scene::SectionMesh &mesh, const dda::Model *blocks)
    {
      std::vector<Vec2> base;
      for (const int node : nodes_of_lines(mesh, {"base"}))
        base.push_back(mesh.nodes[node]);
      if (!base.empty())
        return {nearest_to(middle_of(base), base)};
      if (blocks == nullptr || blocks->n_foundation_nodes() == 0)
        return {};
      const std::vector<Vec2> &surface = blocks->initial.foundation_nodes;
      Vec2                     lowest = surface.front(), low = lowest, high = lowest;
      for (const Vec2 &x : surface)
        {
          lowest = x.y() < lowest.y() ? x : lowest;
          low    = low.cwiseMin(x);
          high   = high.cwiseMax(x);
        }
      return {lowest - Vec2(0., (high - low).norm())};
    }



    /// Digits behind the point that tell positions apart by a thousandth of the whole.
    int digits_of(const std::vector<Vec2> &positions)
    {
      constexpr int most    = 12;
      double        largest = 0.;
      for (const Vec2 &x : positions)
        largest = std::max(largest, (x - positions.front()).norm());
      return largest > 0.
               ? std::clamp(3 - static_cast<int>(std::floor(std::log10(largest))), 0, most)
               : 3;
    }



    /// @return how many were added: not those whose name is another's.
    int add(const std::vector<Vec2> &positions, std::vector<scene::Monitor> &points)
    {
      const std::size_t before = points.size();
      const int         digits = digits_of(positions);
      for (const Vec2 &x : positions)
        {
          const std::string name = formatted("x_%.*f_y_%.*f", digits, x.x(), digits, x.y());
          const bool is_new = std::none_of(points.begin(), points.end(), [&](const auto &other) {
            return other.name == name;
          });
          if (is_new)
            points.push_back({name, x});
        }
      return static_cast<int>(points.size() - before);
    }



    std::string counted(const int count, const std::string &what)
    {
      return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
    }
  } // namespace



  std::string WatchedPoints::text() const
  {
    const std::string mass = of_mass > 0 ? counted(of_mass, "block") : "",
                      rock = of_bedrock > 0 ? counted(of_bedrock, "point") + " of the bedrock" : "";
    return mass + (mass.empty() || rock.empty() ? "" : " and ") + rock;
  }



  WatchedPoints
  watched_points(const scene::SectionMesh &mesh, const dda::Model *blocks, const bool bedrock_moves)
  {
    WatchedPoints result;
    if (blocks != nullptr)
      result.of_mass = add(spread(centroids(*blocks), WatchedPoints::most_of_mass), result.points);
    if (bedrock_moves)
      result.of_bedrock = add(spread(middles_at_surface(mesh),
                                     result.of_mass > 0 ? WatchedPoints::most_of_bedrock
                                                        : WatchedPoints::most_of_bedrock_alone),
                              result.points);
    const std::vector<Vec2> base = base_point(mesh, blocks);
    if (result.points.empty() || base.empty())
      return result;
    result.points.push_back({base_name, base.front()});
    result.base = 1;
    return result;
  }
} // namespace hybrid::output
