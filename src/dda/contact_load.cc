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
  } // namespace



  double ContactLoads::Lists::length(const std::vector<Contact> &all, const Contact &contact) const
  {
    return contact_length(geometry, all, contact, corner(contact), nullptr).spring;
  }



  void ContactLoads::carry(const std::vector<Contact> &before,
                           const Geometry             &geometry,
                           const CornerLength         &corner,
                           std::vector<Contact>       &now)
  {
    bool is_sorted = false;
    for (Contact &contact : now)
      {
        if (!is_on_surface(contact, geometry) ||
            std::binary_search(before.begin(), before.end(), contact, comes_before) ||
            Place(contact, geometry).gap >= contact.rest_gap)
          continue;
        if (!is_sorted)
          sort_by_block(before, geometry);
        is_sorted = true;
        begin_as_piece({before, now, geometry, corner}, contact);
      }
  }



  void ContactLoads::sort_by_block(const std::vector<Contact> &before, const Geometry &geometry)
  {
    by_block.clear();
    for (std::size_t c = 0; c < before.size(); ++c)
      if (is_on_surface(before[c], geometry))
        by_block.push_back({mass_block(before[c], geometry), static_cast<int>(c)});
    std::sort(by_block.begin(), by_block.end());
  }



  void ContactLoads::begin_as_piece(const Lists &lists, Contact &contact) const
  {
    const Geometry &geometry = lists.geometry;
    const Place     place(contact, geometry);
    const int       block   = mass_block(contact, geometry);
    const Contact  *nearest = nullptr;
    double          least = std::numeric_limits<double>::infinity(), turn = 0., depth = 0.;
    for (auto it = std::lower_bound(by_block.begin(), by_block.end(), std::make_pair(block, 0));
         it != by_block.end() && it->first == block;
         ++it)
      {
        const Contact &old = lists.before[it->second];
        const Place    then(old, geometry);
        const double   distance = (then.vertex - place.vertex).norm();
        const double   cosine   = then.along.dot(place.along);
        if (distance >= least || distance > 0.5 * std::max(then.length, place.length) ||
            std::abs(cosine) < ContactTolerances{}.continuing_cosine || then.gap >= old.rest_gap)
          continue;
        nearest = &old;
        least   = distance;
        turn    = std::copysign(1., cosine);
        depth   = old.rest_gap - then.gap;
      }
    if (nearest == nullptr)
      return;
    // Slip is that of the vertex along the edge: the other way round where they change roles.
    const bool same_role =
      is_surface(geometry, nearest->vertex_body) == is_surface(geometry, contact.vertex_body);
    const double role = same_role ? 1. : -1.;
    const double own = lists.length(lists.now, contact), its = lists.length(lists.before, *nearest);
    const double part = own > its ? its / own : 1.;
    contact.rest_gap  = std::min(0., place.gap + part * depth);
    contact.plastic_slip =
      contact.slip - role * turn * part * (nearest->slip - nearest->plastic_slip);
  }
} // namespace hybrid::dda
