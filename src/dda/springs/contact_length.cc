// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_tolerances.h>
#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/dda/springs/contact_length.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace hybrid::dda
{
  namespace
  {
    /// Of an edge's length: vertices that are nearer to each other are at one place. Welded
    /// triangles of the bedrock are some millionths apart under load.
    constexpr double same_place_fraction = 1e-4;



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



    double length(const Geometry &geometry, const Walk &walk)
    {
      return (position(geometry, walk.body, walk.end(geometry)) -
              position(geometry, walk.body, walk.begin(geometry)))
        .norm();
    }



    /// Unit vector along the walk.
    Vec2 direction(const Geometry &geometry, const Walk &walk)
    {
      return (position(geometry, walk.body, walk.end(geometry)) -
              position(geometry, walk.body, walk.begin(geometry)))
        .normalized();
    }



    /// Unit normal out of the body: on the right of a block's outline, on the left of the
    /// foundation's.
    Vec2 outward(const Geometry &geometry, const Walk &walk)
    {
      const Vec2   along = direction(geometry, walk);
      const double side  = (walk.body == foundation_body) != walk.forwards ? 1. : -1.;
      return side * Vec2(along.y(), -along.x());
    }



    bool lies_along(const Vec2 &a, const Vec2 &b)
    {
      return a.dot(b) > 0. && std::abs(cross(a, b)) <= ContactTolerances{}.entry_sine;
    }



    /// The edge on which the walk goes on; false at a corner and at an end of the foundation.
    bool advance(const Geometry &geometry, Walk &walk)
    {
      int edge = edge_before(geometry, walk.body, walk.edge);
      if (walk.forwards)
        {
          const int end = end_place(geometry, walk.body, walk.edge);
          edge          = end < 0 ? -1 : edge_after(geometry, walk.body, end);
        }
      if (edge < 0)
        return false;
      const Walk next{body_of(geometry, walk.body, edge), edge, walk.forwards};
      // The outline turns away from the outside where a corner sticks out.
      const Vec2 before = direction(geometry, walk), after = direction(geometry, next);
      if (!lies_along(before, after) ||
          -after.dot(outward(geometry, walk)) > std::sin(ContactTolerances::smooth_angle))
        return false;
      walk = next;
      return true;
    }



    /// True if a vertex touches a body (a surface with any of its edges).
    bool touches(const Geometry             &geometry,
                 const std::vector<Contact> &contacts,
                 const int                   vertex_body,
                 const int                   vertex,
                 const int                   body)
    {
      const auto key    = [](const Contact &c) { return std::make_pair(c.vertex_body, c.vertex); };
      const auto wanted = std::make_pair(vertex_body, vertex);
      auto       found =
        std::lower_bound(contacts.begin(),
                         contacts.end(),
                         wanted,
                         [&](const Contact &c, const auto &value) { return key(c) < value; });
      for (; found != contacts.end() && key(*found) == wanted; ++found)
        if (is_same_body(geometry, found->edge_body, body))
          return true;
      return false;
    }



    /// The two sides of an overlap, walked the same way from one of its ends.
    struct Faces
    {
      Walk   surface, block; ///< block: of the mass; two blocks of it otherwise, in any order
      bool   stops;          ///< at places of the surface: each has a contact of its own
      double same_place;     ///< distance of two vertices at one place [m]
    };



    /// How far a walk goes, and the last edge that it takes.
    struct Reach
    {
      double length; ///< [m]
      Walk   last;
    };



    /// How far what is bonded of a block's edge goes [m]; infinite where the edge itself ends
    /// first.
    double bonded_reach(const Geometry   &geometry,
                        Walk              walk,
                        const Vec2       &origin,
                        const Vec2       &along,
                        const BondedArea &area)
    {
      for (;;)
        {
          const Vec2 end = position(geometry, walk.body, walk.end(geometry));
          if (!advance(geometry, walk) || !lies_along(direction(geometry, walk), along))
            return std::numeric_limits<double>::infinity();
          if (area.of(walk.body, walk.edge) == 0)
            return std::max(0., along.dot(end - origin));
        }
    }



    /// True if the place at one end of the walk's edge touches the block.
    bool is_touching_place(const Geometry             &geometry,
                           const std::vector<Contact> &contacts,
                           const Faces                &faces,
                           const Walk                 &walk,
                           const bool                  at_end)
    {
      const int place =
        walk.forwards == at_end ? end_place(geometry, walk.body, walk.edge) : walk.edge;
      return place >= 0 && touches(geometry,
                                   contacts,
                                   body_of(geometry, walk.body, place),
                                   place,
                                   faces.block.body);
    }



    /// Walk from @p origin along the unit vector @p along, at most as far as @p enough [m].
    Reach reach(const Geometry             &geometry,
                const std::vector<Contact> &contacts,
                const Faces                &faces,
                const bool                  on_surface,
                const Vec2                 &origin,
                const Vec2                 &along,
                const double                enough)
    {
      Walk walk = on_surface ? faces.surface : faces.block;
      // A corner may hang over the end of the edge that it touches.
      const double before = along.dot(position(geometry, walk.body, walk.begin(geometry)) - origin);
      if (on_surface && faces.stops && before > faces.same_place &&
          is_touching_place(geometry, contacts, faces, walk, false))
        return {std::min(before, enough), walk};
      for (;;)
        {
          const double far = along.dot(position(geometry, walk.body, walk.end(geometry)) - origin);
          if (far >= enough)
            return {enough, walk};
          if (on_surface && faces.stops && far > faces.same_place &&
              is_touching_place(geometry, contacts, faces, walk, true))
            return {far, walk};
          const Walk last = walk;
          if (!advance(geometry, walk) || !lies_along(direction(geometry, walk), along))
            return {std::max(0., far), last};
        }
    }



    /// True if the contact's edge ends where its vertex is, seen @p along it, and that end touches
    /// the vertex's body.
    bool shares_place(const Geometry             &geometry,
                      const std::vector<Contact> &contacts,
                      const Contact              &contact,
                      const Vec2                 &along,
                      const double                same_place)
    {
      const Vec2 &x    = position(geometry, contact.vertex_body, contact.vertex);
      const int   body = contact.edge_body;
      for (const int end : {contact.edge, end_place(geometry, body, contact.edge)})
        if (end >= 0 && std::abs(along.dot(position(geometry, body, end) - x)) <= same_place &&
            touches(geometry, contacts, body_of(geometry, body, end), end, contact.vertex_body))
          return true;
      return false;
    }



    /// 1 for edges that lie along each other, falling to 0 at the angle at which they no longer do.
    double closeness(const Vec2 &a, const Vec2 &b)
    {
      const double sine = cross(a, b) / ContactTolerances{}.entry_sine;
      return std::max(0., 1. - sine * sine);
    }



    /// What the vertex at the beginning of a piece of an overlap bears of a uniform load on it [-]:
    /// half, or, the more of an edge of the foundation the piece covers, what the foundation says
    /// of that edge.
    double share_of_piece(const Geometry &geometry,
                          const Reach    &piece,
                          const Vec2     &origin,
                          const Vec2     &along,
                          const double    same_place)
    {
      const Walk &edge = piece.last;
      if (edge.body != foundation_body || geometry.foundation_shares.empty() ||
          along.dot(position(geometry, foundation_body, edge.begin(geometry)) - origin) >
            same_place)
        return 0.5;
      const double first   = geometry.foundation_shares[edge.edge];
      const double all     = edge.forwards ? first : 1. - first;
      const double covered = std::min(1., piece.length / length(geometry, edge));
      return 0.5 + covered * (all - 0.5);
    }



    /// What one edge of the contact's vertex gives it.
    struct Part
    {
      double length    = 0.; ///< of an overlap [m]
      double bonded    = 0.; ///< of it [m]
      double closeness = 0.; ///< [-]
    };



    /// What is bonded of a piece of an overlap [m].
    double bonded_fraction(const Geometry   &geometry,
                           const BondedArea &area,
                           const Contact    &contact,
                           const Walk       &mine,
                           const Reach      &piece,
                           const double      share)
    {
      const bool is_place = is_surface(geometry, mine.body);
      const Walk block    = is_place ? Walk{contact.edge_body, contact.edge, false} : mine;
      const char at_vertex =
        is_place ? BondedArea::both : (mine.forwards ? BondedArea::first : BondedArea::second);
      if ((area.of(block.body, block.edge) & at_vertex) == 0 ||
          area.of(piece.last.body, piece.last.edge) == 0)
        return 0.;
      if (is_place)
        return share * piece.length;
      const Vec2  &origin = position(geometry, contact.vertex_body, contact.vertex);
      const double bonded = bonded_reach(geometry, mine, origin, direction(geometry, mine), area);
      return bonded < piece.length ? bonded : share * piece.length;
    }



    /// An edge of the contact's vertex that lies along the contact's edge, and both walked away
    /// from the vertex.
    struct Facing
    {
      Vec2   origin, along; ///< place of the vertex [m]; unit vector [-]
      double closeness;     ///< [-]
      Faces  faces;
      bool   is_empty; ///< the vertex is a place of a surface beside the block's edge

      /// How far the block's face goes from the vertex, at most as far as @p enough [m].
      double block_reach(const Geometry             &geometry,
                         const std::vector<Contact> &contacts,
                         const double                enough) const
      {
        return reach(geometry, contacts, faces, false, origin, along, enough).length;
      }
    };



    std::optional<Facing> facing(const Geometry &geometry, const Contact &contact, const Walk &mine)
    {
      if (mine.edge < 0)
        return {};
      const Vec2 along = direction(geometry, mine);
      Walk       other{contact.edge_body, contact.edge, true};
      other.forwards = direction(geometry, other).dot(along) > 0.;
      if (!lies_along(direction(geometry, other), along) ||
          outward(geometry, mine).dot(outward(geometry, other)) > 0.)
        return {};
      const Vec2  &origin   = position(geometry, contact.vertex_body, contact.vertex);
      const bool   is_place = is_surface(geometry, mine.body);
      const double same_place =
        same_place_fraction * std::min(length(geometry, mine), length(geometry, other));
      const double begin =
        along.dot(position(geometry, other.body, other.begin(geometry)) - origin);
      return Facing{origin,
                    along,
                    closeness(along, direction(geometry, other)),
                    {is_place ? mine : other,
                     is_place ? other : mine,
                     is_place || is_surface(geometry, other.body),
                     same_place},
                    is_place && begin > same_place};
    }



    /// What a contact bears of one side of the overlap: half of it, a quarter where vertices of
    /// both bodies are at one place, each with a contact of its own.
    double share_of_end(const Geometry             &geometry,
                        const std::vector<Contact> &contacts,
                        const Contact              &contact,
                        const Facing               &facing)
    {
      return shares_place(geometry, contacts, contact, facing.along, facing.faces.same_place) ? 0.5
                                                                                              : 1.;
    }



    Part fraction_of_overlap(const Geometry             &geometry,
                             const std::vector<Contact> &contacts,
                             const Contact              &contact,
                             const Walk                 &mine,
                             const BondedArea           *area)
    {
      const std::optional<Facing> found = facing(geometry, contact, mine);
      if (!found)
        return {};
      Part part{0., 0., found->closeness};
      if (found->is_empty)
        return part;
      // The surface may go on for long: a block does not.
      const double first =
        found->block_reach(geometry, contacts, std::numeric_limits<double>::infinity());
      const Reach piece =
        reach(geometry, contacts, found->faces, true, found->origin, found->along, first);
      const double share =
        share_of_end(geometry, contacts, contact, *found) *
        share_of_piece(geometry, piece, found->origin, found->along, found->faces.same_place);
      part.length = share * piece.length;
      if (area != nullptr && found->faces.stops)
        part.bonded = bonded_fraction(geometry, *area, contact, mine, piece, share);
      return part;
    }



    /**
     * What the springs at one end of an overlap with a surface, which is at the contact's vertex,
     * lack of a corner's [m]: half of what the whole overlap lacks of @p corner, or of the block's
     * face where that is shorter.
     */
    double lack_at_end(const Geometry             &geometry,
                       const std::vector<Contact> &contacts,
                       const Contact              &contact,
                       const Walk                 &mine,
                       const double                corner)
    {
      std::optional<Facing> end = facing(geometry, contact, mine);
      end->faces.stops          = false;
      const double ahead        = end->block_reach(geometry, contacts, corner);
      const double whole =
        reach(geometry, contacts, end->faces, true, end->origin, end->along, ahead).length;
      const double share  = share_of_end(geometry, contacts, contact, *end);
      end->along          = -end->along;
      Walk &block         = end->faces.block;
      block.forwards      = !block.forwards;
      const double behind = end->block_reach(geometry, contacts, corner);
      return 0.5 * share * std::max(0., std::min(corner, ahead + behind) - whole);
    }



    /// How much of a corner a vertex is: 1 for those of blocks and the ends of a surface, less for
    /// a place at which a surface hardly turns, 0 where it does not stick out.
    double sharpness(const Geometry &geometry, const int body, const int vertex)
    {
      if (!is_surface(geometry, body))
        return 1.;
      const int before = edge_before(geometry, body, vertex),
                after  = edge_after(geometry, body, vertex);
      if (before < 0 || after < 0)
        return 1.;
      const Walk   from{body_of(geometry, body, before), before, true}, to{body, after, true};
      const double turn = -direction(geometry, to).dot(outward(geometry, from));
      return std::min(1., std::max(0., turn / ContactTolerances{}.entry_sine));
    }
  } // namespace



  ContactLength contact_length(const Geometry             &geometry,
                               const std::vector<Contact> &contacts,
                               const Contact              &contact,
                               const double                corner,
                               const BondedArea           *area)
  {
    const int  body = contact.vertex_body, vertex = contact.vertex;
    const int  edge_behind = edge_before(geometry, body, vertex);
    const Walk ahead{body, edge_after(geometry, body, vertex), true};
    const Walk behind{edge_behind < 0 ? body : body_of(geometry, body, edge_behind),
                      edge_behind,
                      false};
    const Part a = fraction_of_overlap(geometry, contacts, contact, ahead, area);
    const Part b = fraction_of_overlap(geometry, contacts, contact, behind, area);

    ContactLength result;
    result.overlap = a.length + b.length;
    result.bonded  = a.bonded + b.bonded;
    result.corner  = corner;
    result.spring  = corner;
    if (is_surface(geometry, contact.vertex_body) != is_surface(geometry, contact.edge_body))
      {
        result.face = result.overlap;
        if ((a.length > 0.) != (b.length > 0.))
          result.face +=
            lack_at_end(geometry, contacts, contact, a.length > 0. ? ahead : behind, corner);
        result.closeness = std::max(a.closeness, b.closeness);
        result.corner    = sharpness(geometry, body, vertex) * corner;
        result.spring    = result.at(result.closeness);
      }
    return result;
  }
} // namespace hybrid::dda
