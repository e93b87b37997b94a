// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact_frame.h>
#include <hybrid/dda/contact_load.h>

#include <algorithm>
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


    double geometric_gap(const Contact &contact, const Geometry &geometry)
    {
      const ContactPlaces place = places(contact, geometry);
      return ContactFrame(contact, place.from_q(contact), place.second - place.first).gap;
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
            const double gap = geometric_gap(contact, geometry) - contact.rest_gap;
            if (gap < 0.)
              ended.push_back({std::minmax(contact.vertex_body, contact.edge_body),
                               places(contact, geometry).vertex,
                               -gap});
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
        const double gap = geometric_gap(contact, geometry);
        if (gap - contact.rest_gap >= 0.)
          continue;
        if (!has_looked)
          ended = find_ended(before, now, geometry);
        has_looked         = true;
        const double depth = take_depth(std::minmax(contact.vertex_body, contact.edge_body),
                                        places(contact, geometry).vertex,
                                        ended);
        contact.rest_gap   = std::min(0., gap + depth);
      }
  }
} // namespace hybrid::dda
