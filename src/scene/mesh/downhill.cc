// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/downhill.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybrid::scene
{
  namespace
  {
    constexpr double level = 1e-6; ///< difference of height over width [-]



    /// Nodes of a line's edges; none if there is no such line.
    std::vector<Vec2> points_of(const SectionMesh &mesh, const std::string &name)
    {
      std::vector<Vec2> points;
      const auto        line = mesh.lines.find(name);
      if (line != mesh.lines.end())
        for (const auto &edge : line->second)
          for (const int node : edge)
            points.push_back(mesh.nodes[node]);
      return points;
    }



    /// Both ends of the surface lie above the stretch, or both below it.
    bool is_valley_or_hill(const LineEnds &stretch, const LineEnds &surface)
    {
      const double middle = 0.5 * (stretch.left.y() + stretch.right.y()),
                   near   = level * (surface.right.x() - surface.left.x()),
                   left = surface.left.y() - middle, right = surface.right.y() - middle;
      return std::min(left, right) > near || std::max(left, right) < -near;
    }
  } // namespace



  double LineEnds::downhill() const
  {
    const double fall = left.y() - right.y();
    if (std::abs(fall) <= level * (right.x() - left.x()))
      return 0.;
    return fall > 0. ? 1. : -1.;
  }



  LineEnds ends_of(const std::vector<Vec2> &points, const WallEnd end)
  {
    if (points.empty())
      return {};
    const double up = end == WallEnd::foot ? 1. : -1.;
    LineEnds     ends{points.front(), points.front()};
    for (const Vec2 &x : points)
      {
        if (x.x() < ends.left.x() || (x.x() == ends.left.x() && up * x.y() < up * ends.left.y()))
          ends.left = x;
        if (x.x() > ends.right.x() || (x.x() == ends.right.x() && up * x.y() < up * ends.right.y()))
          ends.right = x;
      }
    return ends;
  }



  LineEnds ends_of_surface(const SectionMesh &mesh)
  {
    const std::vector<Vec2> surface = points_of(mesh, "sliding_surface");
    return ends_of(surface.empty() ? points_of(mesh, "ground") : surface, WallEnd::foot);
  }



  double downhill_beside(const LineEnds &stretch, const SectionMesh &mesh)
  {
    const LineEnds surface = ends_of_surface(mesh);
    return is_valley_or_hill(stretch, surface) ? 0. : surface.downhill();
  }



  double downhill_above(const double left, const double right, const SectionMesh &mesh)
  {
    std::vector<Vec2> above;
    for (const Vec2 &x : points_of(mesh, "mass_surface"))
      if (left <= x.x() && x.x() <= right)
        above.push_back(x);
    return ends_of(above, WallEnd::top).downhill();
  }



  double downhill_sign(const SectionMesh &mesh)
  {
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    const double     sign       = ends_of_surface(mesh).downhill();
    return sign != 0. ? sign : downhill_above(-everywhere, everywhere, mesh);
  }
} // namespace hybrid::scene
