// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact.h>
#include <hybrid/dda/geometry.h>

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
   * normal on the right of the direction), the base has its outward normal on
   * the left of the polyline; that is the only difference between them here.
   * The two ends of the base polyline count as straight: the rock goes on.
   */
  class OutlineFrames
  {
  public:
    void update(const Geometry &geometry, double smooth_angle);

    /// Only the outlines of the given blocks (all others keep what they had), and the base.
    void update(const Geometry &geometry, double smooth_angle, const std::vector<int> &blocks);

    const EdgeFrame &edge(const int body, const int first_end) const
    {
      return body == base_body ? base_edges[first_end] : block_edges[first_end];
    }

    Corner corner(const int body, const int vertex) const
    {
      return body == base_body ? base_corners[vertex] : block_corners[vertex];
    }

    /// True if @p block has no reflex corner.
    bool is_convex(const int block) const
    {
      return convex_blocks[block];
    }

  private:
    void resize(const Geometry &geometry);

    void update_block(const Geometry &geometry, int block, double sine);

    void update_base(const Geometry &geometry, double sine);

    std::vector<EdgeFrame> block_edges, base_edges;
    std::vector<Corner>    block_corners, base_corners;
    std::vector<char>      convex_blocks;
  };


  /// Position of a vertex of a block or of a base node [m].
  inline const Vec2 &position(const Geometry &geometry, const int body, const int vertex)
  {
    return body == base_body ? geometry.base_nodes[vertex] : geometry.vertices[vertex];
  }

  /// The edge before @p vertex, -1 at the first base node.
  inline int edge_before(const Geometry &geometry, const int body, const int vertex)
  {
    return body == base_body ? vertex - 1 : geometry.previous(vertex);
  }

  /// The edge after @p vertex, -1 at the last base node.
  inline int edge_after(const Geometry &geometry, const int body, const int vertex)
  {
    return body == base_body && vertex + 1 == static_cast<int>(geometry.base_nodes.size()) ? -1
                                                                                           : vertex;
  }

  /// Second end of an edge.
  inline int second_end(const Geometry &geometry, const int body, const int edge)
  {
    return body == base_body ? edge + 1 : geometry.next(edge);
  }
} // namespace hybrid::dda
