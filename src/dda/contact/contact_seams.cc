// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of one vertex at seams: edges of several bodies that go on along each other, and what
// lies below them.
#include <hybrid/dda/contact/contact_selection.h>

#include <algorithm>

namespace hybrid::dda
{
  /// The side below a seam: the vertex slides on an edge that the neighbour of this edge continues,
  /// or whose line the edge falls away from with both sides of a tip.
  /// A side that the vertex presses on has stood higher, and holds.
  bool ContactSelection::is_below_seam(const ContactTrial &trial, const Support support) const
  {
    if (trial.history == ContactTrial::History::same_edge && trial.gap <= 0.)
      return false;
    const int   body = trial.contact.edge_body, edge = trial.contact.edge;
    const int   ends[2]{edge, end_place(*geometry, body, edge)};
    const Vec2 &mine = frames->edge(body, trial.contact.edge).normal;
    for (int i = 0; i < 2; ++i)
      {
        const int other = i == 0 ? edge_before(*geometry, body, edge) : edge_following(body, edge);
        if (other < 0 || frames->corner(body, ends[i]) != Corner::convex)
          continue;
        if (is_tip_of_row(body, ends[i], support))
          return true;
        const Vec2  &normal = frames->edge(body, other).normal;
        const double gap    = normal.dot(point - position(*geometry, body, other));
        if (normal.dot(mine) < ContactTolerances::continuing_cosine &&
            (is_level_with_sole(body, ends[i], other) ||
             (support == Support::before ? old.find_continued(body, other, gap) >= 0
                                         : is_level_with_trial(body, other, gap))))
          return true;
      }
    return false;
  }



  /// An edge of the vertex goes on along another one of @p body, which begins or ends at @p corner:
  /// over a crack no edge of a row carries the vertex itself. They are level where the vertex is
  /// and where the corner is: of two tips at one height neither is beside the other.
  bool ContactSelection::is_level_with_sole(const int body, const int corner, const int other) const
  {
    const double level  = with(body).hysteresis();
    const Vec2  &normal = frames->edge(body, other).normal;
    const Vec2   way    = position(*geometry, body, corner) - point;
    if (std::abs(normal.dot(way)) > level)
      return false;
    for (const int e :
         {edge_before(*geometry, vertex_body, vertex), edge_after(*geometry, vertex_body, vertex)})
      if (e >= 0)
        {
          const Vec2 &mine = frames->edge(vertex_body, e).normal;
          if (-normal.dot(mine) >= ContactTolerances::continuing_cosine && mine.dot(way) >= -level)
            return true;
        }
    return false;
  }



  /// One of the trials is an edge that goes on along another one of @p body, whose line is at this
  /// gap from the vertex.
  bool ContactSelection::is_level_with_trial(const int body, const int edge, const double gap) const
  {
    const Vec2 &normal = frames->edge(body, edge).normal;
    return std::any_of(trials.begin(), trials.end(), [&](const ContactTrial &t) {
      const Contact &c = t.contact;
      const double   height =
        PairTolerances::narrower(with(body), of(t)).seam_height(t.gap) +
        step_between(*geometry, *outline, {c.edge_body, c.edge}, {body, edge}, normal);
      return !is_same_body(*geometry, c.edge_body, body) &&
             normal.dot(frames->edge(c.edge_body, c.edge).normal) >=
               ContactTolerances::continuing_cosine &&
             std::abs(gap - t.gap) <= height;
    });
  }



  /// The line of what carries the vertex runs over a tip of @p body (ContactHistory).
  bool
  ContactSelection::is_tip_of_row(const int body, const int corner, const Support support) const
  {
    if (is_surface(*geometry, body))
      return false;
    const Vec2 way = position(*geometry, body, corner) - point;
    if (support == Support::before)
      return old.runs_over_tip(body, corner, way);
    return std::any_of(trials.begin(), trials.end(), [&](const ContactTrial &t) {
      const Vec2 &normal = frames->edge(t.contact.edge_body, t.contact.edge).normal;
      return !is_same_body(*geometry, t.contact.edge_body, body) &&
             t.overhang <= with(body).extension() &&
             falls_away(
               *geometry, *frames, body, corner, normal, ContactTolerances::continuing_sine) &&
             t.gap + normal.dot(way) <=
               PairTolerances::narrower(with(body), of(t)).seam_height(t.gap);
    });
  }



  /// Not a seam: two edges that the vertex had at different heights before, and that meet now. It
  /// is pinched between them or touches both; dropped, a tip between them would pass unseen.
  bool ContactSelection::is_same_seam(const ContactTrial &a, const ContactTrial &b) const
  {
    if (a.history == ContactTrial::History::same_edge &&
        b.history == ContactTrial::History::same_edge)
      return false;
    const Vec2  &na = frames->edge(a.contact.edge_body, a.contact.edge).normal;
    const Vec2  &nb = frames->edge(b.contact.edge_body, b.contact.edge).normal;
    const double height =
      PairTolerances::narrower(of(a), of(b)).seam_height(std::min(a.gap, b.gap)) +
      step_between(*geometry,
                   *outline,
                   {a.contact.edge_body, a.contact.edge},
                   {b.contact.edge_body, b.contact.edge},
                   na);
    return !is_same_body(*geometry, a.contact.edge_body, b.contact.edge_body) &&
           na.dot(nb) >= ContactTolerances::continuing_cosine && std::abs(a.gap - b.gap) <= height;
  }
} // namespace hybrid::dda
