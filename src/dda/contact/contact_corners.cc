// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of corners that meet: the side above a seam, corner against corner.
#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/contact/contact_detection.h>

#include <algorithm>
#include <tuple>

namespace hybrid::dda
{
  void ContactDetection::resolve_corners(const Geometry &geometry)
  {
    dropped.assign(trials.size(), 0);
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (is_above_seam(geometry, i) || (trials[i].gap < 0. && loses_corner(geometry, i)))
        dropped[i] = 1;
  }



  ContactDetection::Range ContactDetection::trials_of(const int body, const int vertex) const
  {
    const int first = body == foundation_body ? first_of_node[vertex] : first_of_vertex[vertex];
    Range     range;
    range.first  = first < 0 ? trials.end() : trials.begin() + first;
    range.second = range.first;
    // vertices of the foundation have numbers of their own
    while (range.second != trials.end() &&
           (range.second->contact.vertex_body == foundation_body) == (body == foundation_body) &&
           range.second->contact.vertex == vertex)
      ++range.second;
    return range;
  }



  /// The side above a seam, seen from the row: the edge's end slides on a third body, and its
  /// support goes on along one of the two edges of the vertex, or over the vertex as a tip.
  bool ContactDetection::is_above_seam(const Geometry &geometry, const std::size_t i) const
  {
    if (trials[i].history == ContactTrial::History::same_edge && trials[i].gap <= 0.)
      return false;
    const Contact           &c          = trials[i].contact;
    const ContactTolerances &tolerances = tolerances_of(c);
    const Vec2              &p          = position(geometry, c.vertex_body, c.vertex);
    const Vec2              &mine       = frames.edge(c.edge_body, c.edge).normal;
    for (const int end : {c.edge, end_place(geometry, c.edge_body, c.edge)})
      {
        if (end < 0)
          continue;
        const Vec2  &q     = position(geometry, c.edge_body, end);
        const double along = std::abs(frames.edge(c.edge_body, c.edge).direction.dot(p - q));
        if (along > 0.1 * tolerances.reach)
          continue;
        if (meets_level(geometry, c, end))
          return true;
        const Range support = trials_of(c.edge_body, end);
        for (auto k = support.first; k != support.second; ++k)
          if (runs_over_tip(geometry, *k, c, p - q))
            return true;
        for (auto k = support.first; k != support.second; ++k)
          for (const int g : {edge_before(geometry, c.vertex_body, c.vertex),
                              edge_after(geometry, c.vertex_body, c.vertex)})
            {
              if (g < 0)
                continue;
              const Vec2  &normal = frames.edge(c.vertex_body, g).normal;
              const double height = PairTolerances::narrower(tolerances, tolerances_of(k->contact))
                                      .seam_height(k->gap) +
                                    step_between(geometry,
                                                 candidates.outline(),
                                                 {k->contact.edge_body, k->contact.edge},
                                                 {c.vertex_body, g},
                                                 normal);
              if (!is_same_body(geometry, k->contact.edge_body, c.vertex_body) &&
                  -mine.dot(normal) < ContactTolerances::continuing_cosine &&
                  normal.dot(frames.edge(k->contact.edge_body, k->contact.edge).normal) >=
                    ContactTolerances::continuing_cosine &&
                  std::abs(normal.dot(q - p) - k->gap) <= height)
                return true;
            }
      }
    return false;
  }



  /// The line of what carries the end of an edge runs over the vertex, a tip below it. The edge is
  /// a side of the slider then: a tip that stands on what slides, or on the ground, is held by it.
  /// @param way from the end to the vertex [m]
  bool ContactDetection::runs_over_tip(const Geometry     &geometry,
                                       const ContactTrial &support,
                                       const Contact      &c,
                                       const Vec2         &way) const
  {
    const Contact &on     = support.contact;
    const Vec2    &normal = frames.edge(on.edge_body, on.edge).normal;
    return !is_surface(geometry, c.vertex_body) && !is_surface(geometry, c.edge_body) &&
           !is_same_body(geometry, on.edge_body, c.vertex_body) &&
           -frames.edge(c.edge_body, c.edge).normal.dot(normal) <
             ContactTolerances::continuing_cosine &&
           support.overhang <= tolerances_of(on).extension() &&
           falls_away(geometry,
                      frames,
                      c.vertex_body,
                      c.vertex,
                      normal,
                      ContactTolerances::continuing_sine) &&
           support.gap + normal.dot(way) <=
             PairTolerances::narrower(tolerances_of(c), tolerances_of(on)).seam_height(support.gap);
  }



  /// The edges of the vertex and of the other body go on along each other at this end of the edge,
  /// a ridge: at the foot of a wall they do, and the wall holds.
  bool
  ContactDetection::meets_level(const Geometry &geometry, const Contact &c, const int end) const
  {
    if (frames.corner(c.edge_body, end) != Corner::convex)
      return false;
    const Vec2 &p = position(geometry, c.vertex_body, c.vertex);
    const Vec2 &q = position(geometry, c.edge_body, end);
    for (const int mine :
         {edge_before(geometry, c.edge_body, end), edge_after(geometry, c.edge_body, end)})
      for (const int g : {edge_before(geometry, c.vertex_body, c.vertex),
                          edge_after(geometry, c.vertex_body, c.vertex)})
        {
          if (mine < 0 || g < 0 || mine == c.edge)
            continue;
          const Vec2 &normal = frames.edge(c.vertex_body, g).normal;
          const auto  faces  = [&](const int edge) {
            return -normal.dot(frames.edge(c.edge_body, edge).normal) >=
                   ContactTolerances::continuing_cosine;
          };
          if (faces(mine) && !faces(c.edge) &&
              std::abs(normal.dot(q - p)) <= tolerances_of(c).hysteresis())
            return true;
        }
    return false;
  }



  /// True if the opposite contact of the two corners is the better one; both decide alike.
  bool ContactDetection::loses_corner(const Geometry &geometry, const std::size_t i) const
  {
    const ContactTrial &mine = trials[i];
    const Contact      &c    = mine.contact;
    const Vec2         &n    = frames.edge(c.edge_body, c.edge).normal;

    for (const int corner : {c.edge, end_place(geometry, c.edge_body, c.edge)})
      {
        if (corner < 0)
          continue;
        const Range opposite = trials_of(c.edge_body, corner);
        for (auto it = opposite.first; it != opposite.second; ++it)
          {
            const int edge = it->contact.edge;
            // segments of the foundation have numbers of their own
            if (it->gap >= 0. || !is_same_body(geometry, it->contact.edge_body, c.vertex_body) ||
                (edge != edge_after(geometry, c.vertex_body, c.vertex) &&
                 edge != edge_before(geometry, c.vertex_body, c.vertex)) ||
                -n.dot(frames.edge(c.vertex_body, edge).normal) >=
                  ContactTolerances::continuing_cosine)
              continue;
            const auto mine_key =
              std::make_tuple(mine.history, mine.gap, -c.vertex_body, -c.vertex);
            const auto theirs_key =
              std::make_tuple(it->history, it->gap, -it->contact.vertex_body, -it->contact.vertex);
            if (mine_key < theirs_key)
              return true;
          }
      }
    return false;
  }
} // namespace hybrid::dda
