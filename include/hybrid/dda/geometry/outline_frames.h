// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/geometry.h>

#include <vector>

namespace hybrid::dda
{
  /// Where an edge points. Edges of no length have zero vectors.
  struct EdgeFrame
  {
    Vec2   direction = Vec2::Zero(); ///< unit vector from first to second end [-]
    Vec2   normal    = Vec2::Zero(); ///< outward unit normal [-]
    double length    = 0.;           ///< [m]
  };


  /// How the outline turns at a vertex.
  enum class Corner
  {
    straight, ///< by no more than the smooth angle
    convex,   ///< the solid sticks out: a vertex that can hit an edge
    reflex    ///< a notch of the solid
  };


  /**
   * Directions of all edges and corners of a geometry, made once per step.
   *
   * An edge is named by its first end. Blocks run counter-clockwise (outward
   * normal on the right of the direction), the foundation has its outward normal on
   * the left of the polyline; that is the only difference between them here.
   * Blocks of the bedrock have the corners of its surface. The two ends of a
   * surface count as straight: the rock goes on.
   */
  class OutlineFrames
  {
  public:
    void update(const Geometry &geometry, double smooth_angle);

    /// Only the outlines of the given blocks (all others keep what they had), and the foundation.
    void update(const Geometry &geometry, double smooth_angle, const std::vector<int> &blocks);

    const EdgeFrame &edge(const int body, const int first_end) const
    {
      return body == foundation_body ? foundation_edges[first_end] : block_edges[first_end];
    }

    Corner corner(const int body, const int vertex) const
    {
      return body == foundation_body ? foundation_corners[vertex] : block_corners[vertex];
    }

  private:
    void resize(const Geometry &geometry);

    void update_edges(const Geometry &geometry, int block);

    void update_corners(const Geometry &geometry, int block, double sine);

    void update_foundation(const Geometry &geometry, double sine);

    std::vector<EdgeFrame> block_edges, foundation_edges;
    std::vector<Corner>    block_corners, foundation_corners;
  };


  /// Position of a vertex of a block or of a foundation node [m].
  inline const Vec2 &position(const Geometry &geometry, const int body, const int vertex)
  {
    return body == foundation_body ? geometry.foundation_nodes[vertex] : geometry.vertices[vertex];
  }

  /// True for the foundation and for blocks of the bedrock: what the mass lies on.
  inline bool is_surface(const Geometry &geometry, const int body)
  {
    return body == foundation_body || body >= geometry.bedrock.first_block;
  }

  /// True if both are parts of one body: that with the same number, or the bedrock.
  inline bool is_same_body(const Geometry &geometry, const int body, const int other)
  {
    return body == other ||
           (body >= geometry.bedrock.first_block && other >= geometry.bedrock.first_block);
  }

  /// The body of an edge, or of the vertex where it begins, that is part of @p body.
  inline int body_of(const Geometry &geometry, const int body, const int edge)
  {
    return body == foundation_body ? foundation_body : geometry.block_of[edge];
  }

  /// The edge before @p vertex, -1 at the first place of a surface.
  inline int edge_before(const Geometry &geometry, const int body, const int vertex)
  {
    if (body == foundation_body)
      return vertex - 1;
    return geometry.bedrock.previous.empty() ? geometry.previous(vertex)
                                             : geometry.bedrock.previous[vertex];
  }

  /// The edge after @p vertex, -1 at the last foundation node.
  inline int edge_after(const Geometry &geometry, const int body, const int vertex)
  {
    return body == foundation_body &&
               vertex + 1 == static_cast<int>(geometry.foundation_nodes.size())
             ? -1
             : vertex;
  }

  /// True of a corner of a block whose edges both lead away below a line with this normal, at an
  /// angle of more than that of this sine.
  inline bool falls_away(const Geometry      &geometry,
                         const OutlineFrames &frames,
                         const int            block,
                         const int            corner,
                         const Vec2          &normal,
                         const double         sine)
  {
    return normal.dot(frames.edge(block, corner).direction) < -sine &&
           normal.dot(frames.edge(block, geometry.previous(corner)).direction) > sine;
  }

  /// Second end of an edge: where it is.
  inline int second_end(const Geometry &geometry, const int body, const int edge)
  {
    return body == foundation_body ? edge + 1 : geometry.next(edge);
  }

  /// Second end of an edge: the vertex as contacts name it (BedrockSurface), -1 at the last place
  /// of the bedrock's surface.
  inline int end_place(const Geometry &geometry, const int body, const int edge)
  {
    return body == foundation_body || geometry.bedrock.next.empty()
             ? second_end(geometry, body, edge)
             : geometry.bedrock.next[edge];
  }
} // namespace hybrid::dda
