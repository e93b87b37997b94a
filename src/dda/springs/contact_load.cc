// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_frame.h>
#include <hybrid/dda/contact/contact_tolerances.h>
#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/dda/springs/contact_length.h>
#include <hybrid/dda/springs/contact_load.h>

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
        const ContactFrame  frame(contact, place);
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
    bool is_found = false;
    for (Contact &contact : now)
      {
        if (std::binary_search(before.begin(), before.end(), contact, comes_before))
          continue;
        const double gap = Place(contact, geometry).gap;
        if (gap >= contact.stress_free_gap)
          continue;
        if (!is_found)
          find_pressing(before, geometry);
        is_found            = true;
        const Range between = pressing_between(bodies_of(contact, geometry));
        if (is_on_surface(contact, geometry) &&
            begin_as_piece({before, now, geometry, corner}, between, contact))
          continue;
        double depth = 0.;
        for (auto it = between.first; it != between.second; ++it)
          depth = std::max(depth, it->depth);
        contact.stress_free_gap = std::min(contact.stress_free_gap, gap + depth);
      }
  }



  void ContactLoads::turn(const Geometry       &geometry,
                          const CornerLength   &corner,
                          std::vector<Contact> &contacts)
  {
    for (Contact &contact : contacts)
      {
        if (!is_on_surface(contact, geometry))
          continue;
        const double gap = Place(contact, geometry).gap;
        if (gap >= contact.stress_free_gap)
          {
            contact.closeness = -1.; // with no load there is none to keep
            continue;
          }
        const ContactLength length =
          contact_length(geometry, contacts, contact, corner(contact), nullptr);
        const double then = contact.closeness;
        contact.closeness = length.closeness;
        if (then < 0. || then == length.closeness || length.spring <= 0.)
          continue;
        const double kept       = std::sqrt(length.at(then) / length.spring);
        contact.stress_free_gap = std::min(std::max(0., contact.stress_free_gap),
                                           gap + kept * (contact.stress_free_gap - gap));
        contact.plastic_slip    = contact.slip - kept * (contact.slip - contact.plastic_slip);
      }
  }



  ContactLoads::Bodies ContactLoads::bodies_of(const Contact &contact, const Geometry &geometry)
  {
    const auto body = [&](const int b) { return is_surface(geometry, b) ? foundation_body : b; };
    return std::minmax({body(contact.vertex_body), body(contact.edge_body)});
  }



  void ContactLoads::find_pressing(const std::vector<Contact> &before, const Geometry &geometry)
  {
    pressing.clear();
    for (std::size_t c = 0; c < before.size(); ++c)
      {
        const double depth = before[c].stress_free_gap - Place(before[c], geometry).gap;
        if (depth > 0.)
          pressing.push_back({bodies_of(before[c], geometry), static_cast<int>(c), depth});
      }
    std::sort(pressing.begin(), pressing.end());
  }



  ContactLoads::Range ContactLoads::pressing_between(const Bodies &bodies) const
  {
    const auto is_before = [](const Pressing &p, const Bodies &b) { return p.bodies < b; };
    const auto is_after  = [](const Bodies &b, const Pressing &p) { return b < p.bodies; };
    return {std::lower_bound(pressing.begin(), pressing.end(), bodies, is_before),
            std::upper_bound(pressing.begin(), pressing.end(), bodies, is_after)};
  }



  bool ContactLoads::begin_as_piece(const Lists &lists, const Range &between, Contact &contact)
  {
    const Geometry &geometry = lists.geometry;
    const Place     place(contact, geometry);
    const Contact  *nearest = nullptr;
    double nearest_distance = std::numeric_limits<double>::infinity(), turn = 0., depth = 0.;
    for (auto it = between.first; it != between.second; ++it)
      {
        const Contact &old = lists.before[it->number];
        const Place    then(old, geometry);
        const double   distance = (then.vertex - place.vertex).norm();
        const double   cosine   = then.along.dot(place.along);
        if (distance >= nearest_distance || distance > 0.5 * std::max(then.length, place.length) ||
            std::abs(cosine) < ContactTolerances{}.continuing_cosine)
          continue;
        nearest          = &old;
        nearest_distance = distance;
        turn             = std::copysign(1., cosine);
        depth            = it->depth;
      }
    if (nearest == nullptr)
      return false;
    // Slip is that of the vertex along the edge: the other way round where they change roles.
    const bool same_role =
      is_surface(geometry, nearest->vertex_body) == is_surface(geometry, contact.vertex_body);
    const double role = same_role ? 1. : -1.;
    const double own = lists.length(lists.now, contact), its = lists.length(lists.before, *nearest);
    const double fraction   = own > its ? its / own : 1.;
    contact.stress_free_gap = std::min(0., place.gap + fraction * depth);
    contact.plastic_slip =
      contact.slip - role * turn * fraction * (nearest->slip - nearest->plastic_slip);
    return true;
  }
} // namespace hybrid::dda
