// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/outline_frames.h>

#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    EdgeFrame make_frame(const Vec2 &a, const Vec2 &b, const double side)
    {
      EdgeFrame frame;
      frame.length = (b - a).norm();
      if (frame.length > 0.)
        frame.direction = (b - a) / frame.length;
      frame.normal = side * Vec2(frame.direction.y(), -frame.direction.x());
      return frame;
    }

    /// @p side is 1 if the solid is on the left of the outline, -1 if on the right.
    Corner make_corner(const EdgeFrame &before,
                       const EdgeFrame &after,
                       const double     side,
                       const double     sine)
    {
      const double turn     = side * cross(before.direction, after.direction);
      const bool   forwards = before.direction.dot(after.direction) > 0.;
      if (forwards && std::abs(turn) <= sine)
        return Corner::straight;
      return turn >= 0. ? Corner::convex : Corner::reflex;
    }
  } // namespace


  void OutlineFrames::update(const Geometry &geometry, const double smooth_angle)
  {
    const double sine = std::sin(smooth_angle);
    resize(geometry);
    for (int b = 0; b < geometry.n_blocks(); ++b)
      update_edges(geometry, b);
    for (int b = 0; b < geometry.n_blocks(); ++b)
      update_corners(geometry, b, sine);
    update_foundation(geometry, sine);
  }



  void OutlineFrames::update(const Geometry         &geometry,
                             const double            smooth_angle,
                             const std::vector<int> &blocks)
  {
    const double sine = std::sin(smooth_angle);
    resize(geometry);
    for (const int b : blocks)
      update_edges(geometry, b);
    for (const int b : blocks)
      update_corners(geometry, b, sine);
    update_foundation(geometry, sine);
  }



  void OutlineFrames::resize(const Geometry &geometry)
  {
    block_edges.resize(geometry.vertices.size());
    block_corners.resize(geometry.vertices.size());
    const int n_nodes = static_cast<int>(geometry.foundation_nodes.size());
    foundation_edges.resize(n_nodes > 0 ? n_nodes - 1 : 0);
    foundation_corners.assign(n_nodes, Corner::straight);
  }



  void OutlineFrames::update_edges(const Geometry &geometry, const int block)
  {
    for (int v = geometry.offset[block]; v < geometry.offset[block + 1]; ++v)
      block_edges[v] = make_frame(geometry.vertices[v], geometry.vertices[geometry.next(v)], 1.);
  }



  void OutlineFrames::update_corners(const Geometry &geometry, const int block, const double sine)
  {
    for (int v = geometry.offset[block]; v < geometry.offset[block + 1]; ++v)
      {
        const int before = edge_before(geometry, block, v);
        block_corners[v] = before < 0 ? Corner::straight
                                      : make_corner(block_edges[before], block_edges[v], 1., sine);
      }
  }



  void OutlineFrames::update_foundation(const Geometry &geometry, const double sine)
  {
    const int n_nodes = static_cast<int>(geometry.foundation_nodes.size());
    for (int i = 0; i + 1 < n_nodes; ++i)
      foundation_edges[i] =
        make_frame(geometry.foundation_nodes[i], geometry.foundation_nodes[i + 1], -1.);
    for (int i = 1; i + 1 < n_nodes; ++i)
      foundation_corners[i] = make_corner(foundation_edges[i - 1], foundation_edges[i], -1., sine);
  }
} // namespace hybrid::dda
