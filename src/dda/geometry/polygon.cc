// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/polygon.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybrid::dda
{
  namespace
  {
    /// Side of @p c as seen from a to b: 1 left, -1 right, 0 on the line.
    int side(const Vec2 &a, const Vec2 &b, const Vec2 &c)
    {
      const double s = cross(b - a, c - a);
      return (s > 0.) - (s < 0.);
    }

    /// True if @p c, known to be on the line through a and b, is between them.
    bool between(const Vec2 &a, const Vec2 &b, const Vec2 &c)
    {
      return std::min(a.x(), b.x()) <= c.x() && c.x() <= std::max(a.x(), b.x()) &&
             std::min(a.y(), b.y()) <= c.y() && c.y() <= std::max(a.y(), b.y());
    }

    bool segments_meet(const Vec2 &a, const Vec2 &b, const Vec2 &c, const Vec2 &d)
    {
      const int s1 = side(a, b, c), s2 = side(a, b, d);
      const int s3 = side(c, d, a), s4 = side(c, d, b);
      if (s1 * s2 < 0 && s3 * s4 < 0)
        return true;
      return (s1 == 0 && between(a, b, c)) || (s2 == 0 && between(a, b, d)) ||
             (s3 == 0 && between(c, d, a)) || (s4 == 0 && between(c, d, b));
    }
  } // namespace


  PolygonMoments polygon_moments(const Vec2 *vertices, const int n)
  {
    PolygonMoments m{0., Vec2::Zero(), 0., 0., 0.};
    Vec2           first = Vec2::Zero(); // integral of the position
    for (int i = 0; i < n; ++i)
      {
        const Vec2   a = vertices[i] - vertices[0];
        const Vec2   b = vertices[i + 1 == n ? 0 : i + 1] - vertices[0];
        const double c = cross(a, b);
        m.area += 0.5 * c;
        first += (c / 6.) * (a + b);
      }
    m.centroid = vertices[0] + first / m.area;

    for (int i = 0; i < n; ++i)
      {
        const Vec2   a = vertices[i] - m.centroid;
        const Vec2   b = vertices[i + 1 == n ? 0 : i + 1] - m.centroid;
        const double c = cross(a, b);
        m.sxx += c / 12. * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
        m.syy += c / 12. * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y());
        m.sxy += c / 24. * (2. * (a.x() * a.y() + b.x() * b.y()) + a.x() * b.y() + b.x() * a.y());
      }
    return m;
  }



  bool is_simple(const Vec2 *vertices, const int n)
  {
    if (n < 3)
      return false;
    for (int i = 0; i < n; ++i)
      {
        const Vec2 &a = vertices[i], &b = vertices[(i + 1) % n], &c = vertices[(i + 2) % n];
        // an edge of no length, or a spike that runs back along its own edge
        if (a == b || (side(a, b, c) == 0 && (b - a).dot(c - b) < 0.))
          return false;
        for (int j = i + 2; j < n; ++j)
          if ((j + 1) % n != i && segments_meet(a, b, vertices[j], vertices[(j + 1) % n]))
            return false;
      }
    return true;
  }



  bool contains(const Vec2 *vertices, const int n, const Vec2 &point)
  {
    bool inside = false;
    for (int i = 0; i < n; ++i)
      {
        const Vec2 &a = vertices[i], &b = vertices[i + 1 == n ? 0 : i + 1];
        if ((a.y() > point.y()) == (b.y() > point.y()))
          continue;
        // the edge crosses the horizontal line through the point: is the crossing to the right?
        const bool left_of_edge = cross(b - a, point - a) > 0.;
        if (left_of_edge == (b.y() > a.y()))
          inside = !inside;
      }
    return inside;
  }



  double distance_to_segment(const Vec2 &a, const Vec2 &b, const Vec2 &point)
  {
    const Vec2   d      = b - a;
    const double length = d.squaredNorm();
    const double t      = length > 0. ? std::clamp(d.dot(point - a) / length, 0., 1.) : 0.;
    return (point - a - t * d).norm();
  }



  double distance_to_outline(const Vec2 *vertices, const int n, const Vec2 &point)
  {
    double distance = std::numeric_limits<double>::max();
    for (int i = 0; i < n; ++i)
      distance =
        std::min(distance,
                 distance_to_segment(vertices[i], vertices[i + 1 == n ? 0 : i + 1], point));
    return distance;
  }
} // namespace hybrid::dda
