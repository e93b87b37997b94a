// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_history.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  ContactHistory::ContactHistory(const PairTolerances &pair_tolerances)
    : pairs(pair_tolerances)
  {}



  void ContactHistory::set(const Geometry      &geometry_,
                           const OutlineFrames &frames_,
                           const BondedOutline &outline_,
                           const Vec2          &point,
                           const Contact       *contacts,
                           const int            n)
  {
    geometry = &geometry_;
    frames   = &frames_;
    outline  = &outline_;
    entries.clear();
    for (int i = 0; i < n; ++i)
      {
        const Contact   &c     = contacts[i];
        const EdgeFrame &edge  = frames->edge(c.edge_body, c.edge);
        const Vec2       r     = point - position(*geometry, c.edge_body, c.edge);
        const double     along = r.dot(edge.direction);
        entries.push_back({&c,
                           r.dot(edge.normal),
                           edge.length > 0. ? along / edge.length : 0.,
                           std::max({0., -along, along - edge.length}),
                           false});
      }
  }



  int ContactHistory::find(const int edge_body, const int edge) const
  {
    for (std::size_t i = 0; i < entries.size(); ++i)
      if (entries[i].contact->edge_body == edge_body && entries[i].contact->edge == edge)
        return static_cast<int>(i);
    return -1;
  }



  int ContactHistory::find_continued(const int edge_body, const int edge, const double gap) const
  {
    const Vec2 &normal = frames->edge(edge_body, edge).normal;
    for (std::size_t i = 0; i < entries.size(); ++i)
      {
        const Entry             &e = entries[i];
        const Contact           &c = *e.contact;
        const ContactTolerances &tolerances =
          PairTolerances::narrower(pairs.of(c.vertex_body, c.edge_body),
                                   pairs.of(c.vertex_body, edge_body));
        const double height =
          tolerances.seam_height(e.gap) + tolerances.continuing_sine * e.overhang +
          step_between(*geometry, *outline, {c.edge_body, c.edge}, {edge_body, edge}, normal);
        if (normal.dot(frames->edge(c.edge_body, c.edge).normal) >= tolerances.continuing_cosine &&
            e.overhang <= 0.5 * tolerances.reach && std::abs(gap - e.gap) <= height)
          return static_cast<int>(i);
      }
    return -1;
  }



  bool ContactHistory::runs_over_tip(const int body, const int corner, const Vec2 &way) const
  {
    return std::any_of(entries.begin(), entries.end(), [&](const Entry &e) {
      const Contact           &c = *e.contact;
      const ContactTolerances &tolerances =
        PairTolerances::narrower(pairs.of(c.vertex_body, c.edge_body),
                                 pairs.of(c.vertex_body, body));
      const Vec2 &normal = frames->edge(c.edge_body, c.edge).normal;
      return !is_same_body(*geometry, c.edge_body, body) && e.overhang <= tolerances.extension() &&
             falls_away(
               *geometry, *frames, body, corner, normal, ContactTolerances::continuing_sine) &&
             e.gap + normal.dot(way) <= tolerances.seam_height(e.gap);
    });
  }



  bool ContactHistory::take(const int number)
  {
    const bool was_free   = !entries[number].taken;
    entries[number].taken = true;
    return was_free;
  }



  void ContactHistory::hand_over(const int number, Contact &contact) const
  {
    const Entry     &from = entries[number];
    const EdgeFrame &then = frames->edge(from.contact->edge_body, from.contact->edge);
    const EdgeFrame &now  = frames->edge(contact.edge_body, contact.edge);
    // the foundation runs against the blocks' sense
    const double sign = then.direction.dot(now.direction) > 0. ? 1. : -1.;
    const double slip =
      from.contact->slip + (from.position - from.contact->edge_position) * then.length;

    contact.slip            = sign * slip;
    contact.plastic_slip    = sign * from.contact->plastic_slip;
    contact.state           = from.contact->state;
    contact.stress_free_gap = from.contact->stress_free_gap;
    contact.closeness       = from.contact->closeness;
  }
} // namespace hybrid::dda
