// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/geometry/geometry.h>

namespace hybrid::dda
{
  /**
   * Gap and slip of a vertex in front of an edge. Everything is measured from the point q of the
   * edge where the vertex projected when last accepted: differences of places far from the
   * origin, or along a long edge, would cost the digits that the residual needs.
   */
  struct ContactFrame
  {
    Vec2   outward;       ///< unit normal out of the edge's body
    Vec2   along;         ///< unit vector along the edge
    double edge_position; ///< projection of the vertex on the edge [-]
    double gap;           ///< [m]
    double slip;          ///< [m]

    /// @param from_q vertex less q.  @param edge second end less first end of the edge [m].
    ContactFrame(const Contact &contact, const Vec2 &from_q, const Vec2 &edge)
    {
      const double length = edge.norm();
      along               = edge / length;
      // Blocks run counter-clockwise, so their outside is on the right; the foundation's is on the
      // left.
      outward           = contact.edge_body == foundation_body ? Vec2(-along.y(), along.x())
                                                               : Vec2(along.y(), -along.x());
      const double slid = along.dot(from_q);
      edge_position     = contact.edge_position + slid / length;
      gap               = outward.dot(from_q);
      slip              = contact.slip + slid;
    }
  };



  /// Places of a contact's vertex and of both ends of its edge.
  struct ContactPlaces
  {
    Vec2 vertex, first, second;

    Vec2 from_q(const Contact &contact) const
    {
      return vertex - first - contact.edge_position * (second - first);
    }
  };



  /// Where they are in @p geometry.
  inline ContactPlaces places(const Contact &contact, const Geometry &geometry)
  {
    ContactPlaces p;
    p.vertex = contact.vertex_body == foundation_body ? geometry.foundation_nodes[contact.vertex]
                                                      : geometry.vertices[contact.vertex];
    if (contact.edge_body == foundation_body)
      {
        p.first  = geometry.foundation_nodes[contact.edge];
        p.second = geometry.foundation_nodes[contact.edge + 1];
      }
    else
      {
        p.first  = geometry.vertices[contact.edge];
        p.second = geometry.vertices[geometry.next(contact.edge)];
      }
    return p;
  }
} // namespace hybrid::dda
