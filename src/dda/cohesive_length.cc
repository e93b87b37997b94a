// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/cohesive_length.h>
#include <hybrid/dda/contact_tolerances.h>
#include <hybrid/dda/outline_frames.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace hybrid::dda
{
  namespace
  {
    /// An edge, and the sense in which its body's outline is walked from it.
    struct Walk
    {
      int  body, edge;
      bool forwards;

      int end(const Geometry &geometry) const
      {
        return forwards ? second_end(geometry, body, edge) : edge;
      }

      int begin(const Geometry &geometry) const
      {
        return forwards ? edge : second_end(geometry, body, edge);
      }
    };



    /// Unit vector along the walk.
    Vec2 direction(const Geometry &geometry, const Walk &walk)
    {
      return (position(geometry, walk.body, walk.end(geometry)) -
              position(geometry, walk.body, walk.begin(geometry)))
        .normalized();
    }



    /// Unit normal out of the body: on the right of a block's outline, on the left of the base's.
    Vec2 outward(const Geometry &geometry, const Walk &walk)
    {
      const Vec2   along = direction(geometry, walk);
      const double side  = (walk.body == base_body) != walk.forwards ? 1. : -1.;
      return side * Vec2(along.y(), -along.x());
    }



    bool lies_along(const Vec2 &a, const Vec2 &b)
    {
      return a.dot(b) > 0. && std::abs(cross(a, b)) <= ContactTolerances{}.entry_sine;
    }



    /// The edge on which the walk goes on; false at a corner and at an end of the base.
    bool advance(const Geometry &geometry, Walk &walk)
    {
      const int end = walk.end(geometry);
      Walk      next{walk.body,
                walk.forwards ? edge_after(geometry, walk.body, end)
                                   : edge_before(geometry, walk.body, end),
                walk.forwards};
      if (next.edge < 0)
        return false;
      // The outline turns away from the outside where a corner sticks out.
      const Vec2 before = direction(geometry, walk), after = direction(geometry, next);
      if (!lies_along(before, after) ||
          -after.dot(outward(geometry, walk)) > std::sin(ContactTolerances::smooth_angle))
        return false;
      walk = next;
      return true;
    }



    /// Where a walk ends [m], and whether the edge goes on there but not what is bonded of it.
    struct Reach
    {
      double length;
      bool   is_border;
    };

    /// How far the walk goes from @p origin along the unit vector @p along, if not to @p enough.
    Reach reach(const Geometry   &geometry,
                Walk              walk,
                const Vec2       &origin,
                const Vec2       &along,
                const double      enough,
                const BondedArea *area)
    {
      for (;;)
        {
          const double far = along.dot(position(geometry, walk.body, walk.end(geometry)) - origin);
          if (far >= enough)
            return {enough, false};
          if (!advance(geometry, walk) || !lies_along(direction(geometry, walk), along))
            return {std::max(0., far), false};
          if (area != nullptr && area->of(walk.body, walk.edge) == 0)
            return {std::max(0., far), true};
        }
    }



    /// Both edges are bonded still, that of the vertex at the vertex.
    bool is_bonded(const BondedArea *area, const Walk &mine, const Walk &other)
    {
      if (area == nullptr)
        return true;
      const char at_vertex = mine.body == base_body ? BondedArea::both
                             : mine.forwards        ? BondedArea::first
                                                    : BondedArea::second;
      return (area->of(mine.body, mine.edge) & at_vertex) != 0 &&
             area->of(other.body, other.edge) != 0;
    }



    bool is_contact(const std::vector<Contact> &contacts,
                    const int                   vertex_body,
                    const int                   vertex,
                    const int                   edge_body,
                    const int                   edge)
    {
      const auto key = [](const Contact &c) {
        return std::make_tuple(c.vertex_body, c.vertex, c.edge_body, c.edge);
      };
      const auto wanted = std::make_tuple(vertex_body, vertex, edge_body, edge);
      const auto found =
        std::lower_bound(contacts.begin(),
                         contacts.end(),
                         wanted,
                         [&](const Contact &c, const auto &value) { return key(c) < value; });
      return found != contacts.end() && key(*found) == wanted;
    }



    /// The part of an overlap that one edge of the contact's vertex gives it [m].
    double part_of_overlap(const Geometry             &geometry,
                           const std::vector<Contact> &contacts,
                           const Contact              &contact,
                           const Walk                 &mine,
                           const BondedArea           *area)
    {
      if (mine.edge < 0)
        return 0.;
      const Vec2 along = direction(geometry, mine);
      Walk       other{contact.edge_body, contact.edge, true};
      other.forwards = direction(geometry, other).dot(along) > 0.;
      if (!lies_along(direction(geometry, other), along) ||
          outward(geometry, mine).dot(outward(geometry, other)) > 0. ||
          !is_bonded(area, mine, other))
        return 0.;
      // The base may go on for long: a block does not.
      const Vec2  &origin    = position(geometry, contact.vertex_body, contact.vertex);
      const double unlimited = std::numeric_limits<double>::infinity();
      const bool   is_base   = mine.body == base_body;
      const Reach  first = reach(geometry, is_base ? other : mine, origin, along, unlimited, area);
      const Reach  overlap =
        reach(geometry, is_base ? mine : other, origin, along, first.length, area);
      const bool ends_in_border =
        overlap.length < first.length ? overlap.is_border : first.is_border;
      const bool is_shared =
        is_contact(contacts, other.body, other.begin(geometry), mine.body, mine.edge);
      return (is_shared ? 0.5 : 1.) * (ends_in_border ? 1. : 0.5) * overlap.length;
    }
  } // namespace



  double cohesive_length(const Geometry             &geometry,
                         const std::vector<Contact> &contacts,
                         const Contact              &contact,
                         const BondedArea           *area)
  {
    const int  body = contact.vertex_body, vertex = contact.vertex;
    const Walk after{body, edge_after(geometry, body, vertex), true};
    const Walk before{body, edge_before(geometry, body, vertex), false};
    return part_of_overlap(geometry, contacts, contact, after, area) +
           part_of_overlap(geometry, contacts, contact, before, area);
  }
} // namespace hybrid::dda
