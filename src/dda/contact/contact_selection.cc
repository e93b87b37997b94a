// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_selection.h>
#include <hybrid/dda/geometry/polygon.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hybrid::dda
{
  namespace
  {
    using History = ContactTrial::History;

    constexpr double same_cosine = 1e-6; ///< directions nearer than this are the same [-]

    bool edge_order(const ContactTrial &a, const ContactTrial &b)
    {
      return std::make_pair(a.contact.edge_body, a.contact.edge) <
             std::make_pair(b.contact.edge_body, b.contact.edge);
    }

    using Segment = std::array<Vec2, 2>;

    /// True if they cross between their ends.
    bool segments_cross(const Segment &a, const Segment &b)
    {
      const auto parts = [](const Segment &s, const Segment &ends) {
        const Vec2 along = s[1] - s[0];
        return cross(along, ends[0] - s[0]) * cross(along, ends[1] - s[0]) < 0.;
      };
      return parts(a, b) && parts(b, a);
    }

    /// What is to be found of the gap.
    enum class Carries
    {
      min_penetration, ///< on one body
      highest          ///< at a seam: the solid that reaches higher
    };


    /// The edge below the vertex, then the edge it came through, then one that is below it without
    /// the help of a valley (a step's upper tread, not the lower one), then the side of a tip by
    /// which it has passed the tip (the other side has no depth), then the gap. Gaps nearer than
    /// @p same [m] are equal: then the edge that the sole runs along, then the lower one.
    bool better(const ContactTrial &a, const ContactTrial &b, const Carries rule, const double same)
    {
      if (a.is_inside != b.is_inside)
        return a.is_inside;
      if (a.history != b.history)
        return a.history > b.history;
      if (a.by_valley != b.by_valley)
        return b.by_valley;
      if (a.has_passed != b.has_passed)
        return a.has_passed;
      if (std::abs(a.gap - b.gap) > same)
        return (a.gap > b.gap) == (rule == Carries::min_penetration);
      if (std::abs(a.below_sole - b.below_sole) > same_cosine)
        return a.below_sole > b.below_sole;
      if (std::abs(a.middle_height - b.middle_height) > same)
        return a.middle_height < b.middle_height;
      return edge_order(a, b);
    }



    /// The few trials of one vertex. With equal gaps the order need not be transitive, which this
    /// sort bears.
    template <typename Iterator>
    void sort_by(const Iterator begin, const Iterator end, const Carries rule, const double same)
    {
      for (Iterator next = begin; next != end; ++next)
        for (Iterator k = next; k != begin && better(*k, *(k - 1), rule, same); --k)
          std::swap(*k, *(k - 1));
    }
  } // namespace


  ContactSelection::ContactSelection(const PairTolerances &pair_tolerances)
    : pairs(pair_tolerances)
    , old(pair_tolerances)
  {}



  void ContactSelection::begin_step(const Geometry      &geometry_,
                                    const OutlineFrames &frames_,
                                    const BondedOutline &outline_)
  {
    geometry   = &geometry_;
    frames     = &frames_;
    outline    = &outline_;
    edge_tests = 0;
  }



  void ContactSelection::begin_vertex(const int      body,
                                      const int      vertex_,
                                      const Contact *old_contacts,
                                      const int      n_old)
  {
    vertex_body = body;
    vertex      = vertex_;
    point       = position(*geometry, body, vertex);
    // At an end of a surface the rock ends at a right angle: its corner bears what tips over it.
    const int after  = edge_after(*geometry, body, vertex),
              before = edge_before(*geometry, body, vertex);
    to_next =
      after < 0 ? Vec2(-frames->edge(body, before).normal) : frames->edge(body, after).direction;
    to_previous = before < 0 ? Vec2(-frames->edge(body, after).normal)
                             : Vec2(-frames->edge(body, before).direction);

    old.set(*geometry, *frames, *outline, point, old_contacts, n_old);
    trials.clear();
    body_begin = 0;
  }



  void ContactSelection::add_edge(const int body, const int edge)
  {
    ++edge_tests;
    const ContactTolerances &tolerances = with(body);
    const EdgeFrame         &frame      = frames->edge(body, edge);
    const Vec2               r          = point - position(*geometry, body, edge);
    const double             gap        = r.dot(frame.normal);
    if (gap > tolerances.reach || frame.length == 0.)
      return;
    const double along = r.dot(frame.direction);
    ContactTrial trial{{vertex_body, vertex, body, edge}, gap, 0., true, History::none, -1};
    trial.overhang     = std::max({0., -along, along - frame.length});
    const double apart = std::hypot(gap, trial.overhang);
    if (trial.overhang > tolerances.search_distance())
      return;
    if ((gap < -tolerances.max_depth || apart > tolerances.search_distance()) &&
        !is_held(body, edge, gap))
      return;
    trial.by_valley = trial.overhang > 0. && is_below_valley(trial.contact, along);
    if (trial.by_valley)
      trial.overhang = 0.;
    trial.origin = old.find(body, edge);
    if (trial.origin >= 0)
      {
        trial.history = History::same_edge;
        trial.contact = old.contact(trial.origin);
      }

    const bool persists = trial.history == History::same_edge;
    if (!passes_angle_test(frame.normal, persists ? tolerances.hold_sine : tolerances.entry_sine) ||
        trial.overhang > allowed_overhang(trial, along))
      return;
    trial.is_inside =
      trial.overhang <= (persists ? tolerances.hysteresis() : tolerances.coincidence());
    if (!persists)
      {
        trial.contact.edge_position = along / frame.length;
        trial.origin                = old.find_continued(body, edge, gap);
        if (trial.origin >= 0)
          trial.history = History::continuing;
      }
    set_place(trial);
    trials.push_back(trial);
  }



  /// A contact of before that presses deeper than a new one may: the block goes by its own size,
  /// not by that of the smallest one.
  bool ContactSelection::is_held(const int body, const int edge, const double gap) const
  {
    if (gap > 0. || old.find(body, edge) < 0)
      return false;
    if (is_surface(*geometry, body))
      return gap >= -with(body).held_depth;
    const int begin = geometry->offset[body];
    return contains(&geometry->vertices[begin], geometry->offset[body + 1] - begin, point);
  }



  void ContactSelection::set_place(ContactTrial &trial) const
  {
    const int  body = trial.contact.edge_body, edge = trial.contact.edge;
    const Vec2 middle    = 0.5 * (position(*geometry, body, edge) +
                               position(*geometry, body, second_end(*geometry, body, edge)));
    const Vec2 to_middle = (middle - point).normalized();
    trial.below_sole     = std::max(to_middle.dot(to_next), to_middle.dot(to_previous));
    trial.middle_height  = middle.y();
  }



  bool ContactSelection::passes_angle_test(const Vec2 &normal, const double sine) const
  {
    return normal.dot(to_next) >= -sine && normal.dot(to_previous) >= -sine;
  }



  /// At a valley the edge goes on below its neighbour: a vertex beside the edge that is near the
  /// neighbour's line touches the line of the edge as well. Pressed into a valley it would else
  /// pass the end of one edge while it is inside the other, and nothing would hold it. In a gentle
  /// valley one edge acts at a time: that holds below the corner only, where the vertex is beside
  /// both.
  bool ContactSelection::is_below_valley(const Contact &contact, const double along) const
  {
    const int  body = contact.edge_body, edge = contact.edge;
    const bool is_first = along < 0.; // at the first end of the edge
    const int  other = is_first ? edge_before(*geometry, body, edge) : edge_following(body, edge);
    if (other < 0)
      return false;
    const EdgeFrame &mine = frames->edge(body, edge), &beside = frames->edge(body, other);
    const Vec2       r   = point - position(*geometry, body, other);
    const double     gap = beside.normal.dot(r), on_beside = beside.direction.dot(r);
    const double     rises = (is_first ? -1. : 1.) * mine.normal.dot(beside.direction);
    if (!(rises > 0. && gap <= with(body).reach && gap >= -with(body).max_depth))
      return false;
    return mine.normal.dot(beside.normal) < ContactTolerances::continuing_cosine ||
           (gap <= 0. && (is_first ? on_beside > beside.length : on_beside < 0.));
  }



  /// How far the vertex may be beside the edge: the room between the normals of two edges of a
  /// surface at a gentle ridge belongs to both of them, otherwise nobody would see a vertex there.
  double ContactSelection::allowed_overhang(const ContactTrial &trial, const double along) const
  {
    const int    body = trial.contact.edge_body;
    const double plain =
      trial.history == History::same_edge ? of(trial).extension() : of(trial).coincidence();
    if (!is_surface(*geometry, body) || trial.gap <= 0. || trial.overhang == 0.)
      return plain;
    const int edge  = trial.contact.edge;
    const int other = along < 0. ? edge_before(*geometry, body, edge) : edge_following(body, edge);
    if (other < 0)
      return plain;
    const Vec2  &normal = frames->edge(body, trial.contact.edge).normal;
    const double cosine = normal.dot(frames->edge(body, other).normal);
    if (cosine < ContactTolerances::continuing_cosine)
      return plain;
    const double sine = std::abs(cross(normal, frames->edge(body, other).normal));
    return std::max(plain, trial.gap * sine / cosine);
  }



  /// The edge that begins where @p edge ends, or -1.
  int ContactSelection::edge_following(const int body, const int edge) const
  {
    const int end = end_place(*geometry, body, edge);
    return end < 0 ? -1 : edge_after(*geometry, body, end);
  }



  /// A new contact of a vertex exactly on a corner, where both edges of the corner would do.
  bool ContactSelection::is_undecided(const ContactTrial &trial) const
  {
    if (trial.history != History::none || std::abs(trial.gap) > of(trial).coincidence())
      return false;
    const int body = trial.contact.edge_body, edge = trial.contact.edge;
    const int ends[2]{edge, end_place(*geometry, body, edge)};
    for (int i = 0; i < 2; ++i)
      {
        const int other = i == 0 ? edge_before(*geometry, body, edge) : edge_following(body, edge);
        if (other < 0 || frames->corner(body, ends[i]) != Corner::convex ||
            (position(*geometry, body, ends[i]) - point).norm() > 2. * of(trial).coincidence())
          continue;
        const Vec2 &normal = frames->edge(body, other).normal;
        if (normal.dot(frames->edge(body, trial.contact.edge).normal) <
              ContactTolerances::continuing_cosine &&
            passes_angle_test(normal, ContactTolerances::entry_sine))
          return true;
      }
    return false;
  }



  /// A new penetrating contact must be inside the block, not behind the line of a far edge.
  bool ContactSelection::is_in_body(const ContactTrial &trial) const
  {
    const int b = trial.contact.edge_body;
    if (trial.history == History::same_edge || trial.gap >= -of(trial).coincidence() ||
        is_surface(*geometry, b))
      return true;
    const int first = geometry->offset[b];
    return contains(&geometry->vertices[first], geometry->offset[b + 1] - first, point);
  }



  /// The vertex has come through this edge and left the body again by the side that meets it at its
  /// near end: tips that have passed each other, or a corner below a tip that lies on what the
  /// vertex is pressed into deeper. An edge of the vertex still leads out through this one, or the
  /// tip is between its edges. In one step it has come no further than the reach.
  bool ContactSelection::has_passed_tip(const ContactTrial &trial) const
  {
    const int body = trial.contact.edge_body;
    if (is_surface(*geometry, vertex_body) || is_surface(*geometry, body))
      return false;
    const std::vector<Vec2> &v     = geometry->vertices;
    const int                first = trial.contact.edge, second = geometry->next(first);
    const bool               nearer = (point - v[first]).norm() <= (point - v[second]).norm();
    const int                tip    = nearer ? first : second;
    const int                beside = nearer ? geometry->previous(first) : second;
    const Vec2               way    = v[tip] - point;
    const double             same   = of(trial).coincidence();
    if (frames->corner(body, tip) != Corner::convex || way.norm() > of(trial).reach ||
        frames->edge(body, beside).normal.dot(way) > same)
      return false;
    const int     before = geometry->previous(vertex);
    const Segment edge{v[first], v[second]};
    return (frames->edge(vertex_body, vertex).normal.dot(way) <= same &&
            frames->edge(vertex_body, before).normal.dot(way) <= same) ||
           segments_cross(edge, {point, v[geometry->next(vertex)]}) ||
           segments_cross(edge, {point, v[before]});
  }



  /// Two edges of one body act together only where they face each other: in a notch.
  bool ContactSelection::may_act_together(const ContactTrial &a, const ContactTrial &b) const
  {
    const auto middle = [this](const Contact &c) -> Vec2 {
      return 0.5 * (position(*geometry, c.edge_body, c.edge) +
                    position(*geometry, c.edge_body, second_end(*geometry, c.edge_body, c.edge)));
    };
    const EdgeFrame &fa = frames->edge(a.contact.edge_body, a.contact.edge);
    const EdgeFrame &fb = frames->edge(b.contact.edge_body, b.contact.edge);
    const Vec2       ab = middle(b.contact) - middle(a.contact);
    return a.is_inside && b.is_inside &&
           fa.normal.dot(fb.normal) < ContactTolerances::continuing_cosine &&
           fa.normal.dot(ab) > 0. && fb.normal.dot(ab) < 0.;
  }



  int ContactSelection::end_body()
  {
    const auto begin = trials.begin() + body_begin;
    for (auto t = begin; t != trials.end(); ++t)
      t->has_passed = t->gap < -of(*t).coincidence() && has_passed_tip(*t);
    // decide before erasing: the rules look at one trial at a time
    trials.erase(std::remove_if(begin,
                                trials.end(),
                                [this](const ContactTrial &t) {
                                  return is_undecided(t) || is_below_seam(t, Support::before) ||
                                         !(t.has_passed || is_in_body(t));
                                }),
                 trials.end());
    if (trials.size() > body_begin + 1)
      sort_by(trials.begin() + body_begin,
              trials.end(),
              Carries::min_penetration,
              of(trials.back()).coincidence());

    std::size_t kept = body_begin;
    for (std::size_t i = body_begin; i < trials.size(); ++i)
      {
        bool acts = true;
        for (std::size_t j = body_begin; j < kept && acts; ++j)
          acts = may_act_together(trials[j], trials[i]);
        if (acts)
          trials[kept++] = trials[i];
      }
    trials.erase(trials.begin() + kept, trials.end());
    const int n = static_cast<int>(kept - body_begin);
    body_begin  = kept;
    return n;
  }



  void ContactSelection::end_vertex(std::vector<ContactTrial> &all)
  {
    // Where a vertex touches a row for the first time, nothing before says that it slides on it.
    below_seam.assign(trials.size(), 0);
    for (std::size_t i = 0; i < trials.size(); ++i)
      below_seam[i] = is_below_seam(trials[i], Support::now) ? 1 : 0;
    std::size_t left = 0;
    double      same = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (!below_seam[i])
        {
          same           = std::min(same, of(trials[i]).coincidence());
          trials[left++] = trials[i];
        }
    trials.erase(trials.begin() + left, trials.end());
    sort_by(trials.begin(), trials.end(), Carries::highest, same);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < trials.size(); ++i)
      {
        bool acts = true;
        for (std::size_t j = 0; j < kept && acts; ++j)
          acts = !is_same_seam(trials[j], trials[i]);
        if (acts)
          trials[kept++] = trials[i];
      }
    trials.erase(trials.begin() + kept, trials.end());
    std::sort(trials.begin(), trials.end(), edge_order);

    // Slip of an edge that the vertex has left goes to the first edge that continues it.
    for (const ContactTrial &t : trials)
      if (t.history == History::same_edge)
        old.take(t.origin);
    for (ContactTrial &t : trials)
      if (t.history == History::continuing && old.take(t.origin))
        old.hand_over(t.origin, t.contact);
    all.insert(all.end(), trials.begin(), trials.end());
  }
} // namespace hybrid::dda
