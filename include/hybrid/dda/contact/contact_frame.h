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
   * The gap and slip of a contact that presses are summed over the steps, as jumps of joints are
   * (Springs): each step adds what its displacements make of them. The places themselves are
   * rounded in every step, by 1e-14 m at 100 m from the origin, which a stiff contact would feel;
   * they count again once it has parted. Where nothing moves, nothing changes, to the last bit.
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
    {
      const double length = set_directions(contact, start.second - start.first);
      if (contact.pressed_gap < 0.)
        set_pressed(contact, 0., 0., 0.);
      else
        set_by_places(contact, start.from_q(contact), length);
    }

    /// After displacements @p moved from the @p start places; @p then is the unit vector along the
    /// edge there.
    ContactFrame(const Contact       &contact,
                 const ContactPlaces &start,
                 const Vec2          &then,
                 const ContactPlaces &moved)
    {
      const Vec2   by = moved.from_q(contact);
      const double length =
        set_directions(contact, (start.second - start.first) + (moved.second - moved.first));
      if (contact.pressed_gap < 0.)
        {
          // The vertex was at the gap along the normal of then, square to the edge of then.
          const Vec2   turned     = along - then;
          const Vec2   normal     = outward_of(contact, then);
          const double gap_turned = -0.5 * contact.pressed_gap * turned.squaredNorm();
          set_pressed(contact,
                      outward.dot(by) + gap_turned,
                      along.dot(by) + contact.pressed_gap * turned.dot(normal),
                      length);
        }
      else
        set_by_places(contact, start.from_q(contact) + by, length);
    }

  private:
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

    /// @param from_q vertex less q [m]
    void set_by_places(const Contact &contact, const Vec2 &from_q, const double length)
    {
      const double slid = along.dot(from_q);
      edge_position     = contact.edge_position + slid / length;
      gap               = outward.dot(from_q);
      slip              = contact.slip + slid;
    }

    /// @param opened, slid since it was accepted [m]
    void
    set_pressed(const Contact &contact, const double opened, const double slid, const double length)
    {
      edge_position = contact.edge_position + (slid == 0. ? 0. : slid / length);
      gap           = contact.pressed_gap + opened;
      slip          = contact.slip + slid;
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
