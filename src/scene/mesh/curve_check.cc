// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/curve_check.h>
#include <hybrid/scene/types.h>

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace hybrid::scene
{
  namespace
  {
    constexpr double rounding = 1e-9; ///< of a length over the longer edge [-]

    /// An edge of the mesh of a curve.
    struct Segment
    {
      int                        curve;
      bool                       within; ///< the curve lies within the surface, not on its boundary
      std::array<std::size_t, 2> node;
      std::array<Vec2, 2>        x; ///< [m]
    };


    /// "bedding_1 (curve 5)", or "curve 5".
    std::string name_of(const int curve)
    {
      std::vector<int> groups;
      gmsh::model::getPhysicalGroupsForEntity(1, curve, groups);
      std::string name;
      if (!groups.empty())
        gmsh::model::getPhysicalName(1, std::abs(groups.front()), name);
      const std::string number = "curve " + std::to_string(curve);
      return name.empty() ? number : name + " (" + number + ")";
    }


    void add_segments(const int curve, const bool within, std::vector<Segment> &segments)
    {
      std::vector<std::size_t> tags;
      std::vector<double>      x, parameters;
      gmsh::model::mesh::getNodes(tags, x, parameters, 1, curve, true);
      std::map<std::size_t, Vec2> position;
      for (std::size_t i = 0; i < tags.size(); ++i)
        position[tags[i]] = Vec2(x[3 * i], x[3 * i + 1]);
      std::vector<std::size_t> elements, ends;
      gmsh::model::mesh::getElementsByType(1, elements, ends, curve); // two-node lines
      for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
        if (position.count(ends[i]) > 0 && position.count(ends[i + 1]) > 0)
          segments.push_back(
            {curve, within, {ends[i], ends[i + 1]}, {position[ends[i]], position[ends[i + 1]]}});
    }


    /// Boundary and inner curves of a surface, as edges ordered by their left ends.
    std::vector<Segment> segments_of(const std::pair<int, int> &surface)
    {
      std::vector<Segment> segments;
      gmsh::vectorpair     boundary, inner;
      gmsh::model::getBoundary({surface}, boundary, true, false, false);
      gmsh::model::mesh::getEmbedded(2, surface.second, inner);
      for (const auto &curve : boundary)
        add_segments(std::abs(curve.second), false, segments);
      for (const auto &curve : inner)
        if (curve.first == 1)
          add_segments(curve.second, true, segments);
      const auto left = [](const Segment &s) { return std::min(s.x[0].x(), s.x[1].x()); };
      std::sort(segments.begin(), segments.end(), [&](const Segment &a, const Segment &b) {
        return left(a) < left(b);
      });
      return segments;
    }


    /// A place where two edges without a common node meet in a way that gmsh cannot mesh.
    bool meet(const Segment &a, const Segment &b, Vec2 &place)
    {
      for (const std::size_t i : a.node)
        for (const std::size_t j : b.node)
          if (i == j)
            return false;
      const Vec2   u = a.x[1] - a.x[0], v = b.x[1] - b.x[0], d = b.x[0] - a.x[0];
      const double size = std::max(u.norm(), v.norm()), area = cross(u, v);
      // An end of the one on the other.
      if (a.within || b.within)
        for (const auto &[from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
          for (const Vec2 &end : from->x)
            {
              const Vec2   w = to->x[1] - to->x[0];
              const double t = (end - to->x[0]).dot(w) / w.squaredNorm();
              if (t >= 0. && t <= 1. && (end - to->x[0] - t * w).norm() <= rounding * size)
                {
                  place = end;
                  return true;
                }
            }
      if (std::abs(area) <= rounding * u.norm() * v.norm())
        return false; // parallel
      const double s = cross(d, v) / area, t = cross(d, u) / area;
      place = a.x[0] + s * u;
      return s > rounding && s < 1. - rounding && t > rounding && t < 1. - rounding;
    }


    std::string at(const Vec2 &x)
    {
      std::ostringstream text;
      text << "(" << x.x() << ", " << x.y() << ") m";
      return text.str();
    }


    void check_surface(const std::string &file, const std::pair<int, int> &surface)
    {
      const std::vector<Segment>   segments = segments_of(surface);
      std::vector<const Segment *> open;
      for (const Segment &a : segments)
        {
          const double left = std::min(a.x[0].x(), a.x[1].x());
          open.erase(std::remove_if(open.begin(),
                                    open.end(),
                                    [&](const Segment *b) {
                                      return std::max(b->x[0].x(), b->x[1].x()) <
                                             left - rounding * (b->x[1] - b->x[0]).norm();
                                    }),
                     open.end());
          Vec2 place;
          for (const Segment *b : open)
            if (b->curve != a.curve && meet(*b, a, place))
              throw InputError(file,
                               0,
                               name_of(b->curve) + " and " + name_of(a.curve) + " of surface " +
                                 std::to_string(surface.second) + " cross or touch at " +
                                 at(place) +
                                 " without a common point, which gmsh cannot mesh: curves may "
                                 "meet at the end of one, in a Point that both have, and the "
                                 "surface must be divided along them.");
          open.push_back(&a);
        }
    }
  } // namespace


  void check_curves(const std::string &file)
  {
    gmsh::vectorpair surfaces;
    gmsh::model::getEntities(surfaces, 2);
    for (const auto &surface : surfaces)
      check_surface(file, surface);
  }


  std::string curves_within_surfaces()
  {
    constexpr int    max_named = 4; // named one by one
    int              count     = 0;
    std::string      text;
    gmsh::vectorpair surfaces;
    gmsh::model::getEntities(surfaces, 2);
    for (const auto &surface : surfaces)
      {
        gmsh::vectorpair inner;
        gmsh::model::mesh::getEmbedded(2, surface.second, inner);
        for (const auto &curve : inner)
          if (curve.first == 1 && ++count <= max_named)
            text += (text.empty() ? "" : ", ") + name_of(curve.second) + " within surface " +
                    std::to_string(surface.second);
      }
    return count > max_named ? text + ", ..." : text;
  }
} // namespace hybrid::scene
