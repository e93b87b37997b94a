// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact_detection.h>
#include <hybrid/dda/polygon.h>

#include <algorithm>
#include <cassert>
#include <tuple>

namespace hybrid::dda
{
  namespace
  {
    ContactTolerances make_tolerances(const ContactDetection::Parameters &parameters)
    {
      ContactTolerances t;
      t.reach     = parameters.reach;
      t.max_depth = parameters.max_depth < 0. ? parameters.reach : parameters.max_depth;
      return t;
    }

    /// A vertex farther than this from an edge is no partner: the allowed overhangs add less than 5
    /// %.
    double search_distance(const ContactTolerances &t)
    {
      return 1.05 * std::max(t.reach, t.max_depth) + t.extension();
    }

    bool contact_order(const Contact &a, const Contact &b)
    {
      return std::tie(a.vertex_body, a.vertex, a.edge_body, a.edge) <
             std::tie(b.vertex_body, b.vertex, b.edge_body, b.edge);
    }

    bool same_vertex(const ContactCandidate &a, const ContactCandidate &b)
    {
      return a.vertex_body == b.vertex_body && a.vertex == b.vertex;
    }
  } // namespace


  ContactDetection::ContactDetection(const Parameters &parameters)
    : smooth_angle(parameters.smooth_angle)
    , tolerances(make_tolerances(parameters))
    , candidates(search_distance(tolerances), parameters.margin)
    , selection(tolerances)
  {
    assert(parameters.reach > 0. && parameters.margin >= 0.);
  }



  void ContactDetection::update(const Geometry &geometry, std::vector<Contact> &contacts)
  {
    assert(std::is_sorted(contacts.begin(), contacts.end(), contact_order));
    last.builds += candidates.update(geometry) ? 1 : 0;
    last.lost       = 0;
    last.edge_tests = 0;
    if (candidates.awake().empty()) // the search sleeps
      {
        contacts.clear();
        return;
      }
    ++last.searches;
    find_near_blocks(geometry, contacts);
    frames.update(geometry, smooth_angle, near_blocks);

    previous.assign(contacts.begin(), contacts.end());
    select(geometry);
    resolve_corners(geometry);

    contacts.clear();
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (!dropped[i])
        contacts.push_back(trials[i].contact);
    last.edge_tests = selection.n_edge_tests();
  }



  void ContactDetection::find_near_blocks(const Geometry             &geometry,
                                          const std::vector<Contact> &contacts)
  {
    is_near.assign(geometry.n_blocks(), 0);
    near_blocks.clear();
    const auto add = [this](const int body) {
      if (body == base_body || is_near[body])
        return;
      is_near[body] = 1;
      near_blocks.push_back(body);
    };
    for (const ContactCandidate &pair : candidates.awake())
      {
        add(pair.vertex_body);
        add(pair.edge_body);
      }
    for (const Contact &contact : contacts)
      {
        add(contact.vertex_body);
        add(contact.edge_body);
      }
  }



  void ContactDetection::select(const Geometry &geometry)
  {
    const std::vector<ContactCandidate> &list = candidates.awake();

    trials.clear();
    first_of_vertex.assign(geometry.vertices.size(), -1);
    first_of_node.assign(geometry.base_nodes.size(), -1);
    selection.begin_step(geometry, frames);
    auto old = previous.begin();
    for (std::size_t i = 0, end; i < list.size(); i = end)
      {
        for (end = i + 1; end < list.size() && same_vertex(list[i], list[end]);)
          ++end;
        const int body = list[i].vertex_body, vertex = list[i].vertex;
        if (frames.corner(body, vertex) != Corner::convex)
          continue;

        old          = std::lower_bound(old,
                               previous.end(),
                               Contact{body, vertex, base_body, -1},
                               contact_order);
        auto old_end = old;
        while (old_end != previous.end() && old_end->vertex_body == body &&
               old_end->vertex == vertex)
          ++old_end;
        selection.begin_vertex(body,
                               vertex,
                               previous.data() + (old - previous.begin()),
                               static_cast<int>(old_end - old));

        for (std::size_t j = i; j < end; ++j)
          {
            add_body(geometry, list[j]);
            if (j + 1 == end || list[j + 1].edge_body != list[j].edge_body)
              {
                const int n = selection.end_body();
                if (n == 0 && list[j].edge < 0 &&
                    is_lost(geometry, body, vertex, list[j].edge_body))
                  ++last.lost;
              }
          }
        const std::size_t first = trials.size();
        selection.end_vertex(trials);
        if (trials.size() > first)
          (body == base_body ? first_of_node : first_of_vertex)[vertex] = static_cast<int>(first);
      }
  }



  void ContactDetection::add_body(const Geometry &geometry, const ContactCandidate &candidate)
  {
    const int body = candidate.edge_body;
    if (candidate.edge >= 0)
      selection.add_edge(body, candidate.edge);
    else
      for (int e = geometry.offset[body]; e < geometry.offset[body + 1]; ++e)
        selection.add_edge(body, e);
  }



  bool ContactDetection::is_lost(const Geometry &geometry,
                                 const int       vertex_body,
                                 const int       vertex,
                                 const int       block) const
  {
    const Vec2 *outline = &geometry.vertices[geometry.offset[block]];
    const int   n       = geometry.offset[block + 1] - geometry.offset[block];
    const Vec2 &point   = position(geometry, vertex_body, vertex);
    return contains(outline, n, point) &&
           distance_to_outline(outline, n, point) > tolerances.max_depth;
  }



  void ContactDetection::resolve_corners(const Geometry &geometry)
  {
    dropped.assign(trials.size(), 0);
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (is_above_seam(geometry, i) || (trials[i].gap < 0. && loses_corner(geometry, i)))
        dropped[i] = 1;
  }



  ContactDetection::Range ContactDetection::trials_of(const int body, const int vertex) const
  {
    const int first = body == base_body ? first_of_node[vertex] : first_of_vertex[vertex];
    Range     range;
    range.first  = first < 0 ? trials.end() : trials.begin() + first;
    range.second = range.first;
    while (range.second != trials.end() && range.second->contact.vertex_body == body &&
           range.second->contact.vertex == vertex)
      ++range.second;
    return range;
  }



  /// The side above a seam, seen from the row: the edge's end slides on a third body, and its
  /// support goes on along one of the two edges of the vertex.
  bool ContactDetection::is_above_seam(const Geometry &geometry, const std::size_t i) const
  {
    if (trials[i].history == ContactTrial::History::same_edge)
      return false;
    const Contact &c    = trials[i].contact;
    const Vec2    &p    = position(geometry, c.vertex_body, c.vertex);
    const Vec2    &mine = frames.edge(c.edge_body, c.edge).normal;
    for (const int end : {c.edge, second_end(geometry, c.edge_body, c.edge)})
      {
        const Vec2  &q     = position(geometry, c.edge_body, end);
        const double along = std::abs(frames.edge(c.edge_body, c.edge).direction.dot(p - q));
        if (along > 0.1 * tolerances.reach)
          continue;
        const Range support = trials_of(c.edge_body, end);
        for (auto k = support.first; k != support.second; ++k)
          for (const int g : {edge_before(geometry, c.vertex_body, c.vertex),
                              edge_after(geometry, c.vertex_body, c.vertex)})
            {
              const Vec2  &normal = frames.edge(c.vertex_body, g).normal;
              const double height = tolerances.hysteresis() + 0.5 * std::max(0., -k->gap);
              if (k->contact.edge_body != c.vertex_body &&
                  -mine.dot(normal) < tolerances.continuing_cosine &&
                  normal.dot(frames.edge(k->contact.edge_body, k->contact.edge).normal) >=
                    tolerances.continuing_cosine &&
                  std::abs(normal.dot(q - p) - k->gap) <= height)
                return true;
            }
      }
    return false;
  }



  /// True if the opposite contact of the two corners is the better one; both decide alike.
  bool ContactDetection::loses_corner(const Geometry &geometry, const std::size_t i) const
  {
    const ContactTrial &mine = trials[i];
    const Contact      &c    = mine.contact;
    const Vec2         &n    = frames.edge(c.edge_body, c.edge).normal;

    for (const int corner : {c.edge, second_end(geometry, c.edge_body, c.edge)})
      {
        const Range opposite = trials_of(c.edge_body, corner);
        for (auto it = opposite.first; it != opposite.second; ++it)
          {
            const int edge = it->contact.edge;
            // segments of the base have numbers of their own
            if (it->gap >= 0. || it->contact.edge_body != c.vertex_body ||
                (edge != c.vertex && second_end(geometry, c.vertex_body, edge) != c.vertex) ||
                -n.dot(frames.edge(c.vertex_body, edge).normal) >= tolerances.continuing_cosine)
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
