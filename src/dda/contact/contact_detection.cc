// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_detection.h>
#include <hybrid/dda/contact/displacement_spread.h>
#include <hybrid/dda/geometry/polygon.h>

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
      t.reach      = parameters.reach;
      t.max_depth  = parameters.max_depth < 0. ? parameters.reach : parameters.max_depth;
      t.held_depth = std::max(t.max_depth, parameters.held_depth);
      return t;
    }

    bool contact_order(const Contact &a, const Contact &b)
    {
      return std::tie(a.vertex_body, a.vertex, a.edge_body, a.edge) <
             std::tie(b.vertex_body, b.vertex, b.edge_body, b.edge);
    }

    /// Before all contacts of the vertex.
    Contact first_of(const ContactCandidate &pair)
    {
      return {pair.vertex_body, pair.vertex, foundation_body, -1};
    }

    bool is_of(const Contact &contact, const ContactCandidate &pair)
    {
      return contact.vertex_body == pair.vertex_body && contact.vertex == pair.vertex;
    }

    /// Of these sorted contacts one is of the pair: with its edge of a surface, or with any of its
    /// block.
    bool has_contact(const std::vector<Contact> &contacts,
                     const ContactCandidate     &pair,
                     const bool                  is_of_surface)
    {
      auto contact =
        std::lower_bound(contacts.begin(), contacts.end(), first_of(pair), contact_order);
      for (; contact != contacts.end() && is_of(*contact, pair); ++contact)
        if (contact->edge_body == pair.edge_body && (!is_of_surface || contact->edge == pair.edge))
          return true;
      return false;
    }

    /// Of the vertex from the nearest point of the edge [m].
    double distance_to_edge(const Geometry &geometry, const Contact &contact)
    {
      return distance_to_segment(position(geometry, contact.edge_body, contact.edge),
                                 position(geometry,
                                          contact.edge_body,
                                          second_end(geometry, contact.edge_body, contact.edge)),
                                 position(geometry, contact.vertex_body, contact.vertex));
    }

    bool same_vertex(const ContactCandidate &a, const ContactCandidate &b)
    {
      return a.vertex_body == b.vertex_body && a.vertex == b.vertex;
    }
  } // namespace


  ContactDetection::ContactDetection(const Parameters &parameters)
    : smooth_angle(parameters.smooth_angle)
    , waking_slack(parameters.waking_slack)
    , pairs(make_tolerances(parameters))
    , candidates(pairs, parameters.margin)
    , selection(pairs)
  {
    assert(parameters.reach > 0. && parameters.margin >= 0.);
  }



  void ContactDetection::update(const Geometry       &geometry,
                                std::vector<Contact> &contacts,
                                RestState            &rest)
  {
    assert(std::is_sorted(contacts.begin(), contacts.end(), contact_order));
    keep_deep_contacts(geometry, contacts);
    last.builds += candidates.update(geometry) ? 1 : 0;
    last.lost       = 0;
    last.edge_tests = 0;
    if (candidates.awake().empty()) // the search sleeps
      {
        contacts.clear();
        return;
      }
    watch.look(geometry, rest, pairs.narrowest().coincidence());
    if (is_all_settled(contacts, rest))
      return;
    ++last.searches;
    find_near_blocks(geometry, contacts);
    frames.update(geometry, smooth_angle, near_blocks);

    previous.assign(contacts.begin(), contacts.end());
    select(geometry, rest);
    resolve_corners(geometry);

    contacts.clear();
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (!dropped[i])
        {
          Contact &contact = trials[i].contact;
          if (trials[i].history == ContactTrial::History::none &&
              candidates.is_first_activation(contact.vertex_body, contact.edge_body))
            contact.stress_free_gap =
              std::min(0., trials[i].gap - waking_slack * tolerances_of(contact).reach);
          contacts.push_back(contact);
        }
    settle(contacts, rest);
    last.edge_tests = selection.n_edge_tests();
  }



  /// Pairs of an edge that lie deeper behind it than the search looks for others, unless a pair of
  /// their block is near anyway.
  void ContactDetection::keep_deep_contacts(const Geometry             &geometry,
                                            const std::vector<Contact> &contacts)
  {
    deep_pairs.clear();
    for (const Contact &c : contacts)
      if (ContactCandidates::lists_edges(geometry, c.edge_body) &&
          distance_to_edge(geometry, c) > tolerances_of(c).search_distance())
        deep_pairs.push_back({c.vertex_body, c.vertex, c.edge_body, c.edge});
    candidates.keep_awake(deep_pairs);
  }



  bool ContactDetection::is_passed(const Geometry             &geometry,
                                   const std::vector<Contact> &contacts,
                                   const StepMotion           &motion)
  {
    DisplacementSpread spread;
    spread.add(motion.vertices);
    spread.add(motion.nodes);
    if (2. * spread.half_diagonal() <= pairs.narrowest().reach)
      return false;
    const auto move = [](const auto &from, const auto &by, auto &to) {
      to.resize(from.size());
      for (std::size_t i = 0; i < from.size(); ++i)
        to[i] = from[i] + by[i];
    };
    move(geometry.vertices, motion.vertices, moved_vertices);
    move(geometry.foundation_nodes, motion.nodes, moved_nodes);
    last.builds +=
      candidates.list_for(geometry, moved_vertices, moved_nodes, spread.half_diagonal()) ? 1 : 0;
    const ContactPassage passage(geometry, motion, pairs);
    return std::any_of(candidates.all().begin(),
                       candidates.all().end(),
                       [&](const ContactCandidate &pair) {
                         return passage.takes(pair) &&
                                !has_contact(contacts, pair, is_surface(geometry, pair.edge_body));
                       });
  }



  ContactDetection::Group ContactDetection::group_at(const std::size_t begin) const
  {
    const std::vector<ContactCandidate> &list = candidates.awake();
    Group                                group{begin, begin + 1};
    while (group.end < list.size() && same_vertex(list[begin], list[group.end]))
      ++group.end;
    return group;
  }



  bool ContactDetection::group_rests(const Group &group) const
  {
    for (std::size_t i = group.begin; i < group.end; ++i)
      {
        const ContactCandidate &pair = candidates.awake()[i];
        if (!watch.rests(pair) || candidates.is_first_activation(pair.vertex_body, pair.edge_body))
          return false;
      }
    return true;
  }



  bool ContactDetection::is_all_settled(const std::vector<Contact> &contacts, RestState &rest) const
  {
    const std::vector<ContactCandidate> &list = candidates.awake();
    std::size_t kept = 0; // contacts of vertices in the list: the others go
    Group       group;
    for (std::size_t i = 0; i < list.size(); i = group.end)
      {
        group = group_at(i);
        if (!StillnessCache::settled(rest, list[i].vertex_body, list[i].vertex) ||
            !group_rests(group))
          return false;
        while (kept < contacts.size() && is_of(contacts[kept], list[i]))
          ++kept;
      }
    return kept == contacts.size();
  }



  void ContactDetection::settle(const std::vector<Contact> &contacts, RestState &rest)
  {
    const std::vector<ContactCandidate> &list = candidates.awake();
    auto                                 then = previous.cbegin();
    auto                                 now  = contacts.cbegin();
    Group                                group;
    for (std::size_t i = 0; i < list.size(); i = group.end)
      {
        group = group_at(i);
        while (then != previous.cend() && contact_order(*then, first_of(list[i])))
          ++then;
        bool is_same = true;
        for (; now != contacts.cend() && is_of(*now, list[i]); ++now)
          {
            is_same = is_same && then != previous.cend() && is_of(*then, list[i]) &&
                      then->edge_body == now->edge_body && then->edge == now->edge;
            if (is_same)
              ++then;
          }
        is_same = is_same && (then == previous.cend() || !is_of(*then, list[i]));
        if (!is_same || !group_rests(group))
          StillnessCache::settled(rest, list[i].vertex_body, list[i].vertex) = 0;
      }
  }



  void ContactDetection::find_near_blocks(const Geometry             &geometry,
                                          const std::vector<Contact> &contacts)
  {
    is_near.assign(geometry.n_blocks(), 0);
    near_blocks.clear();
    const auto add = [this](const int body) {
      if (body == foundation_body || is_near[body])
        return;
      is_near[body] = 1;
      near_blocks.push_back(body);
    };
    const auto add_with_surface = [&](const int body, const int edge) {
      add(body);
      if (body < geometry.bedrock.first_block)
        return;
      for (const int beside : {geometry.bedrock.previous[edge], geometry.bedrock.next[edge]})
        if (beside >= 0)
          add(geometry.block_of[beside]);
    };
    for (const ContactCandidate &pair : candidates.awake())
      {
        add_with_surface(pair.vertex_body, pair.vertex);
        add_with_surface(pair.edge_body, pair.edge);
      }
    for (const Contact &contact : contacts)
      {
        add_with_surface(contact.vertex_body, contact.vertex);
        add_with_surface(contact.edge_body, contact.edge);
      }
  }



  void ContactDetection::select(const Geometry &geometry, RestState &rest)
  {
    const std::vector<ContactCandidate> &list = candidates.awake();

    trials.clear();
    first_of_vertex.assign(geometry.vertices.size(), -1);
    first_of_node.assign(geometry.foundation_nodes.size(), -1);
    selection.begin_step(geometry, frames, candidates.outline());
    auto  old = previous.begin();
    Group group;
    for (std::size_t i = 0; i < list.size(); i = group.end)
      {
        group          = group_at(i);
        const int body = list[i].vertex_body, vertex = list[i].vertex;
        char     &settled = StillnessCache::settled(rest, body, vertex);
        if (!is_surface(geometry, body) && (frames.corner(body, vertex) != Corner::convex ||
                                            candidates.outline().covers_corner(geometry, vertex)))
          {
            settled = 1;
            continue;
          }
        old          = std::lower_bound(old, previous.end(), first_of(list[i]), contact_order);
        auto old_end = old;
        while (old_end != previous.end() && is_of(*old_end, list[i]))
          ++old_end;
        const Contact    *olds  = previous.data() + (old - previous.begin());
        const int         n_old = static_cast<int>(old_end - old);
        const std::size_t first = trials.size();

        if (settled && group_rests(group))
          keep(geometry, olds, n_old);
        else
          settled = search(geometry, group, olds, n_old);
        if (trials.size() > first)
          (body == foundation_body ? first_of_node : first_of_vertex)[vertex] =
            static_cast<int>(first);
      }
  }



  void
  ContactDetection::keep(const Geometry &geometry, const Contact *old_contacts, const int n_old)
  {
    for (int k = 0; k < n_old; ++k)
      {
        const Contact &c = old_contacts[k];
        const Vec2     r =
          position(geometry, c.vertex_body, c.vertex) - position(geometry, c.edge_body, c.edge);
        const double gap = r.dot(frames.edge(c.edge_body, c.edge).normal);
        trials.push_back({c, gap, 0., true, ContactTrial::History::same_edge, k});
      }
  }



  bool ContactDetection::search(const Geometry &geometry,
                                const Group    &group,
                                const Contact  *old_contacts,
                                const int       n_old)
  {
    const std::vector<ContactCandidate> &list = candidates.awake();
    const int body = list[group.begin].vertex_body, vertex = list[group.begin].vertex;
    selection.begin_vertex(body, vertex, old_contacts, n_old);
    int n_lost = 0;
    for (std::size_t j = group.begin; j < group.end; ++j)
      {
        add_body(geometry, list[j]);
        if (j + 1 < group.end && is_same_body(geometry, list[j + 1].edge_body, list[j].edge_body))
          continue;
        const int n = selection.end_body();
        if (n == 0 && list[j].edge < 0 && is_lost(geometry, body, vertex, list[j].edge_body))
          ++n_lost;
      }
    selection.end_vertex(trials);
    last.lost += n_lost;
    return n_lost == 0;
  }



  void ContactDetection::add_body(const Geometry &geometry, const ContactCandidate &candidate)
  {
    const int body = candidate.edge_body;
    if (candidate.edge >= 0)
      selection.add_edge(body, candidate.edge);
    else
      for (int e = geometry.offset[body]; e < geometry.offset[body + 1]; ++e)
        if (!candidates.outline().covers(e) &&
            !candidates.is_joint_edge(candidate.vertex_body, body, e))
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
           distance_to_outline(outline, n, point) > pairs.of(vertex_body, block).max_depth;
  }
} // namespace hybrid::dda
