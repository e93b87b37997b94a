// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/scene/types.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * What bonds make of the outlines of blocks.
   *
   * Blocks that are bonded are one body, but for the step that the springs of their joint leave
   * between them. What touches that body must see neither the edges along which it is bonded nor
   * the steps of its outline.
   */
  class BondedOutline
  {
  public:
    /// Nothing is bonded.
    BondedOutline() = default;

    explicit BondedOutline(const Geometry &geometry)
      : is_bonded(geometry.vertices.size(), 0)
      , node(geometry.vertices.size())
    {
      for (std::size_t v = 0; v < node.size(); ++v)
        node[v] = static_cast<int>(v);
    }

    /// A bond lies along two edges of two blocks, which run against each other.
    void bond(const Geometry &geometry, int edge, int other);

    /// A bond lies along the edge of a block: nothing else can touch it.
    bool covers(const int edge) const
    {
      return !is_bonded.empty() && is_bonded[edge] != 0;
    }

    /// Bonds lie along both edges of a vertex of a block: others stand for it.
    bool covers_corner(const Geometry &geometry, const int vertex) const
    {
      return covers(vertex) && covers(geometry.previous(vertex));
    }

    /// The same number for vertices that bonds hold together at one node of the mesh.
    int node_of(const int vertex) const
    {
      return root(vertex);
    }

    /// Two edges of two blocks that go on in one another where bonds hold their ends together: the
    /// step there along a normal [m], >= 0. Else 0.
    double step(const Geometry &geometry, int edge, int other, const Vec2 &normal) const;

    friend bool operator==(const BondedOutline &a, const BondedOutline &b)
    {
      return a.is_bonded == b.is_bonded && a.node == b.node;
    }

  private:
    std::vector<char> is_bonded; ///< per vertex: the edge that begins there
    std::vector<int>  node;      ///< per vertex: the lowest of those that bonds hold together

    void unite(int vertex, int other);
    int  root(int vertex) const;
  };


  /// An edge of a body.
  struct BodyEdge
  {
    int body, edge;
  };


  /// BondedOutline::step() of edges of two bodies; 0 if one is a surface.
  inline double step_between(const Geometry      &geometry,
                             const BondedOutline &outline,
                             const BodyEdge      &a,
                             const BodyEdge      &b,
                             const Vec2          &normal)
  {
    return is_surface(geometry, a.body) || is_surface(geometry, b.body)
             ? 0.
             : outline.step(geometry, a.edge, b.edge, normal);
  }
} // namespace hybrid::dda
