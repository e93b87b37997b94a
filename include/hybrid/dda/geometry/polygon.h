// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

namespace hybrid::dda
{
  /**
   * Area moments of a simple polygon, positive for counter-clockwise outlines.
   *
   * Found by simplex integration (Shi 1988): the polygon is the signed sum of
   * the triangles (origin, p_i, p_i+1), and the integrals of polynomials over
   * a triangle are exact. The origin is the first vertex for area and
   * centroid, then the centroid for the second moments, so that a small block
   * far from the coordinate origin loses no digits.
   */
  struct PolygonMoments
  {
    double area;     ///< [m2]
    Vec2   centroid; ///< [m]
    double sxx;      ///< integral of (x - x_c)^2 [m4]
    double sxy;      ///< integral of (x - x_c)(y - y_c) [m4]
    double syy;      ///< integral of (y - y_c)^2 [m4]
  };


  /// Moments of the polygon with @p n vertices; allocates nothing.
  PolygonMoments polygon_moments(const Vec2 *vertices, int n);

  /**
   * True if the outline neither crosses nor touches itself, has at least three
   * vertices and no edge of length zero. Compares every pair of edges: for
   * input checks.
   */
  bool is_simple(const Vec2 *vertices, int n);

  /// True if @p point is inside (even-odd rule; points on the outline may be either).
  bool contains(const Vec2 *vertices, int n, const Vec2 &point);

  /// Distance [m] of @p point from the segment between @p a and @p b.
  double distance_to_segment(const Vec2 &a, const Vec2 &b, const Vec2 &point);

  /// Distance [m] of @p point, inside or outside, from the polygon's outline.
  double distance_to_outline(const Vec2 *vertices, int n, const Vec2 &point);
} // namespace hybrid::dda
