// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/geometry/geometry.h>

namespace hybrid::dda
{
  /// Places of a contact's vertex and of both ends of its edge, or how they have moved.
  struct ContactPlaces
  {
    Vec2 vertex, first, second;

    Vec2 from_q(const Contact &contact) const
    {
      return vertex - first - contact.edge_position * (second - first);
    }
  };


  /**
   * Gap and slip of a vertex in front of an edge. Everything is measured from the point q of the
   * edge where the vertex projected when last accepted: differences of places far from the
   * origin, or along a long edge, would cost the digits that the residual needs.
   *
   * Slip is summed over the steps, as jumps of joints are (Springs), and so is the gap of a contact
   * that presses: each step adds what its displacements make of them. The places themselves are
   * rounded in every step, by 1e-14 m at 100 m from the origin, which a stiff contact would feel;
   * they count for the gap of a contact that is open. Where nothing moves, nothing changes, to the
   * last bit.
   */
  struct ContactFrame
  {
    Vec2   outward;       ///< unit normal out of the edge's body
    Vec2   along;         ///< unit vector along the edge
    double edge_position; ///< projection of the vertex on the edge [-]
    double gap;           ///< [m]
    double slip;          ///< [m]

    /// When the step begins, with the @p start places.
    ContactFrame(const Contact &contact, const ContactPlaces &start)
      : edge_position(contact.edge_position)
      , slip(contact.slip)
    {
      set_directions(contact, start.second - start.first);
      gap = gap_at_start(contact, start, outward);
    }

    /// After displacements @p moved from the @p start places; @p then is the unit vector along the
    /// edge there.
    ContactFrame(const Contact       &contact,
                 const ContactPlaces &start,
                 const Vec2          &then,
                 const ContactPlaces &moved)
    {
      const double length =
        set_directions(contact, (start.second - start.first) + (moved.second - moved.first));
      // The vertex was at the gap along the normal of then, square to the edge of then.
      const Vec2   by = moved.from_q(contact), turned = along - then;
      const Vec2   normal = outward_of(contact, then);
      const double before = gap_at_start(contact, start, normal);
      const double slid   = along.dot(by) + before * turned.dot(normal);
      edge_position       = contact.edge_position + slid / length;
      gap                 = before + (outward.dot(by) - 0.5 * before * turned.squaredNorm());
      slip                = contact.slip + slid;
    }

  private:
    static double
    gap_at_start(const Contact &contact, const ContactPlaces &start, const Vec2 &outward)
    {
      return contact.pressed_gap < 0. ? contact.pressed_gap : outward.dot(start.from_q(contact));
    }

    /// Blocks run counter-clockwise, so their outside is on the right; the foundation's is on the
    /// left.
    static Vec2 outward_of(const Contact &contact, const Vec2 &direction)
    {
      return contact.edge_body == foundation_body ? Vec2(-direction.y(), direction.x())
                                                  : Vec2(direction.y(), -direction.x());
    }

    /// @return length of the edge [m]
    double set_directions(const Contact &contact, const Vec2 &edge)
    {
      const double length = edge.norm();
      along               = edge / length;
      outward             = outward_of(contact, along);
      return length;
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
