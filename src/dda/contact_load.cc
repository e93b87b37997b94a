// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact_frame.h>
#include <hybrid/dda/contact_length.h>
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



    /// A contact before whose load a new one carries on.
    struct Load
    {
      const Contact *contact; ///< nullptr: none
      double         depth;   ///< its overlap [m]
      double         turn;    ///< 1, or -1 if the edges run against each other
    };



    Load nearest_load(const std::vector<Contact> &before,
                      const Geometry             &geometry,
                      const Place                &place,
                      const Contact              &contact)
    {
      const int block = mass_block(contact, geometry);
      Load      load{nullptr, 0., 0.};
      double    least = std::numeric_limits<double>::infinity();
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
          least = distance;
          load  = {&old, old.rest_gap - then.gap, std::copysign(1., cosine)};
        }
      return load;
    }



    /// Overlap and elastic slip of a contact that begins with a load: @p part of those before.
    void begin_with(const Load     &load,
                    const double    part,
                    const Geometry &geometry,
                    const Place    &place,
                    Contact        &contact)
    {
      const Contact &old = *load.contact;
      // Slip is that of the vertex along the edge: the other way round where they change roles.
      const bool same_role =
        is_surface(geometry, old.vertex_body) == is_surface(geometry, contact.vertex_body);
      const double turn    = same_role ? load.turn : -load.turn;
      contact.rest_gap     = std::min(0., place.gap + part * load.depth);
      contact.plastic_slip = contact.slip - turn * part * (old.slip - old.plastic_slip);
    }
  } // namespace



  void carry_loads(const std::vector<Contact>                   &before,
                   const Geometry                               &geometry,
                   const std::function<double(const Contact &)> &corner,
                   std::vector<Contact>                         &now)
  {
    const auto length = [&](const std::vector<Contact> &all, const Contact &contact) {
      return contact_length(geometry, all, contact, corner(contact), nullptr).spring;
    };
    for (Contact &contact : now)
      {
        if (!is_on_surface(contact, geometry) ||
            std::binary_search(before.begin(), before.end(), contact, comes_before))
          continue;
        const Place place(contact, geometry);
        if (place.gap >= contact.rest_gap)
          continue;
        const Load load = nearest_load(before, geometry, place, contact);
        if (load.contact == nullptr)
          continue;
        const double own = length(now, contact), its = length(before, *load.contact);
        begin_with(load, own > its ? its / own : 1., geometry, place, contact);
      }
  }
} // namespace hybrid::dda
