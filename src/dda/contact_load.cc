// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact_frame.h>
#include <hybrid/dda/contact_load.h>
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
    bool comes_before(const Contact &a, const Contact &b)
    {
      return std::tie(a.vertex_body, a.vertex, a.edge_body, a.edge) <
             std::tie(b.vertex_body, b.vertex, b.edge_body, b.edge);
    }


    /// Where a contact is now.
    struct Place
    {
      Vec2   vertex; ///< [m]
      Vec2   along;  ///< unit vector of the edge [-]
      double length; ///< of the edge [m]
      double gap;    ///< [m]

      Place(const Contact &contact, const Geometry &geometry)
      {
        const ContactPlaces place = places(contact, geometry);
        const Vec2          edge  = place.second - place.first;
        const ContactFrame  frame(contact, place.from_q(contact), edge);
        vertex = place.vertex;
        along  = frame.along;
        length = edge.norm();
        gap    = frame.gap;
      }
    };



    bool is_on_surface(const Contact &contact, const Geometry &geometry)
    {
      return is_surface(geometry, contact.vertex_body) != is_surface(geometry, contact.edge_body);
    }



    /// The block of the mass in a contact with a surface.
    int mass_block(const Contact &contact, const Geometry &geometry)
    {
      return is_surface(geometry, contact.vertex_body) ? contact.edge_body : contact.vertex_body;
    }



    /// A new contact of a block with a surface is a piece of an overlap that was there: it begins
    /// with the overlap and the elastic slip of the nearest contact before, whose length it takes
    /// over.
    /// @return false if there was none on these edges.
    bool begin_as_piece(const std::vector<Contact> &before,
                        const Geometry             &geometry,
                        const Place                &place,
                        Contact                    &contact)
    {
      if (!is_on_surface(contact, geometry))
        return false;
      const int      block   = mass_block(contact, geometry);
      const Contact *nearest = nullptr;
      double         least = std::numeric_limits<double>::infinity(), turn = 0., depth = 0.;
      for (const Contact &old : before)
        {
          if (!is_on_surface(old, geometry) || mass_block(old, geometry) != block)
            continue;
          const Place  then(old, geometry);
          const double distance = (then.vertex - place.vertex).norm();
          const double cosine   = then.along.dot(place.along);
          if (distance >= least || distance > 0.5 * std::max(then.length, place.length) ||
              std::abs(cosine) < ContactTolerances{}.continuing_cosine || then.gap >= old.rest_gap)
            continue;
          nearest = &old;
          least   = distance;
          turn    = std::copysign(1., cosine);
          depth   = old.rest_gap - then.gap;
        }
      if (nearest == nullptr)
        return false;
      // Slip is that of the vertex along the edge: the other way round where they change roles.
      const bool same_role =
        is_surface(geometry, nearest->vertex_body) == is_surface(geometry, contact.vertex_body);
      const double role    = same_role ? 1. : -1.;
      contact.rest_gap     = std::min(0., place.gap + depth);
      contact.plastic_slip = contact.slip - role * turn * (nearest->slip - nearest->plastic_slip);
      return true;
    }



    /// A contact that has ended while it pressed.
    struct Ended
    {
      std::pair<int, int> bodies;
      Vec2                place; ///< of the vertex [m]
      double              depth; ///< that its spring was pressed by [m]
    };


    std::vector<Ended> find_ended(const std::vector<Contact> &before,
                                  const std::vector<Contact> &now,
                                  const Geometry             &geometry)
    {
      std::vector<Ended> ended;
      for (const Contact &contact : before)
        if (!std::binary_search(now.begin(), now.end(), contact, comes_before))
          {
            const Place  place(contact, geometry);
            const double gap = place.gap - contact.rest_gap;
            if (gap < 0.)
              ended.push_back(
                {std::minmax(contact.vertex_body, contact.edge_body), place.vertex, -gap});
          }
      return ended;
    }


    /// Take the depth of the nearest that ended between these bodies; 0 if there is none.
    double
    take_depth(const std::pair<int, int> &bodies, const Vec2 &place, std::vector<Ended> &ended)
    {
      auto nearest = ended.end();
      for (auto one = ended.begin(); one != ended.end(); ++one)
        if (one->bodies == bodies && (nearest == ended.end() || (one->place - place).norm() <
                                                                  (nearest->place - place).norm()))
          nearest = one;
      if (nearest == ended.end())
        return 0.;
      const double depth = nearest->depth;
      ended.erase(nearest);
      return depth;
    }
  } // namespace



  void carry_loads(const std::vector<Contact> &before,
                   const Geometry             &geometry,
                   std::vector<Contact>       &now)
  {
    std::vector<Ended> ended;
    bool               has_looked = false;
    for (Contact &contact : now)
      {
        if (std::binary_search(before.begin(), before.end(), contact, comes_before))
          continue;
        const Place place(contact, geometry);
        if (place.gap >= contact.rest_gap || begin_as_piece(before, geometry, place, contact))
          continue;
        if (!has_looked)
          ended = find_ended(before, now, geometry);
        has_looked = true;
        const double depth =
          take_depth(std::minmax(contact.vertex_body, contact.edge_body), place.vertex, ended);
        contact.rest_gap = std::min(0., place.gap + depth);
      }
  }
} // namespace hybrid::dda
