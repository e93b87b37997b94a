// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact.h>
#include <hybrid/dda/contact_candidates.h>
#include <hybrid/dda/polygon.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybrid::dda
{
  namespace
  {
    /// Outlines with more edges name those that are near: a layer of bedrock has hundreds.
    constexpr int many_edges = 16;

    using Pairs = std::vector<std::pair<int, int>>;

    bool has_pair(const Pairs &sorted, const int first, const int second)
    {
      return std::binary_search(sorted.begin(), sorted.end(), std::make_pair(first, second));
    }

    /// True if @p body has any pair in the list.
    bool has_first(const Pairs &sorted, const int first)
    {
      const auto it = std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(first, -1));
      return it != sorted.end() && it->first == first;
    }

    /// Box around the displacements of points. NaN spoils it for good.
    struct Spread
    {
      double lower_x = 0., upper_x = 0., lower_y = 0., upper_y = 0., sum = 0.;
      bool   is_empty = true;

      void add(const std::vector<Vec2> &now, const std::vector<Vec2> &then)
      {
        for (std::size_t i = 0; i < now.size(); ++i)
          {
            const double x = now[i].x() - then[i].x(), y = now[i].y() - then[i].y();
            if (is_empty)
              {
                lower_x = upper_x = x;
                lower_y = upper_y = y;
                is_empty          = false;
              }
            lower_x = std::min(lower_x, x);
            upper_x = std::max(upper_x, x);
            lower_y = std::min(lower_y, y);
            upper_y = std::max(upper_y, y);
            sum += x + y;
          }
      }

      /// No displacement is farther from the box's middle [m].
      double half_diagonal() const
      {
        return 0.5 * std::hypot(upper_x - lower_x, upper_y - lower_y) + 0. * sum;
      }
    };

    Box box_around(const Vec2 *points, const int n, const double skin)
    {
      Box box{points[0], points[0]};
      for (int i = 1; i < n; ++i)
        {
          box.lower = box.lower.cwiseMin(points[i]);
          box.upper = box.upper.cwiseMax(points[i]);
        }
      box.lower.array() -= skin;
      box.upper.array() += skin;
      return box;
    }
  } // namespace


  ContactCandidates::ContactCandidates(const double distance_, const double margin_)
    : distance(distance_)
    , margin(margin_)
  {}



  void ContactCandidates::set_neighbours(const std::vector<int> &offset,
                                         const std::vector<int> &list)
  {
    neighbour_offset = offset;
    neighbours       = list;
    for (std::size_t b = 0; b + 1 < offset.size(); ++b)
      std::sort(neighbours.begin() + offset[b], neighbours.begin() + offset[b + 1]);
    is_outdated = true;
  }



  void ContactCandidates::set_skipped_pairs(const SkippedPairs &given)
  {
    if (given.bonded == skipped.bonded && given.bonded_base == skipped.bonded_base &&
        given.awake == skipped.awake && given.bedrock == skipped.bedrock)
      return;
    skipped = given;
    lookup  = given;
    for (const auto &[a, b] : given.bonded)
      lookup.bonded.emplace_back(b, a);
    std::sort(lookup.bonded.begin(), lookup.bonded.end());
    std::sort(lookup.bonded_base.begin(), lookup.bonded_base.end());
    is_outdated = true;
  }



  bool ContactCandidates::update(const Geometry &geometry)
  {
    const double moved   = movement(geometry);
    const bool   is_good = moved <= 0.5 * margin; // false for NaN
    if (!is_good)
      build(geometry);
    wake(is_good ? moved : 0.);
    return !is_good;
  }



  double ContactCandidates::movement(const Geometry &geometry) const
  {
    if (is_outdated || geometry.vertices.size() != built_vertices.size() ||
        geometry.base_nodes.size() != built_nodes.size())
      return std::numeric_limits<double>::infinity();
    Spread spread;
    spread.add(geometry.vertices, built_vertices);
    spread.add(geometry.base_nodes, built_nodes);
    return spread.half_diagonal();
  }



  void ContactCandidates::wake(const double moved)
  {
    if (moved == awake_for)
      return;
    awake_for = moved;
    awake_pairs.clear();
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (apart_when_built[i] - 2. * moved <= distance)
        awake_pairs.push_back(candidates[i]);
  }



  void ContactCandidates::build(const Geometry &geometry)
  {
    built_vertices.assign(geometry.vertices.begin(), geometry.vertices.end());
    built_nodes.assign(geometry.base_nodes.begin(), geometry.base_nodes.end());
    is_outdated    = false;
    awake_for      = -1.;
    distance_tests = 0;

    const int n_nodes = static_cast<int>(geometry.base_nodes.size());
    boxes.clear();
    for (int i = 0; i + 1 < n_nodes; ++i)
      boxes.push_back(box_around(&geometry.base_nodes[i], 2, distance + margin));
    for (int b = 0; b < geometry.n_blocks(); ++b)
      boxes.push_back(box_around(&geometry.vertices[geometry.offset[b]],
                                 geometry.offset[b + 1] - geometry.offset[b],
                                 distance + margin));
    grid.build(boxes);

    candidates.clear();
    apart_when_built.clear();
    for (int i = 1; i + 1 < n_nodes; ++i) // the two ends of the base are no vertices
      add_candidates(geometry, base_body, i);
    for (int v = 0; v < static_cast<int>(geometry.vertices.size()); ++v)
      add_candidates(geometry, geometry.block_of[v], v);
  }



  void ContactCandidates::add_candidates(const Geometry &geometry, const int body, const int vertex)
  {
    const Vec2 &point = body == base_body ? geometry.base_nodes[vertex] : geometry.vertices[vertex];
    const int   n_segments = std::max(0, static_cast<int>(geometry.base_nodes.size()) - 1);

    found.clear();
    grid.find(point, found);
    std::sort(found.begin(), found.end()); // base segments first, as base_body is the smallest body
    for (const int box : found)
      if (box < n_segments)
        {
          if (body == base_body || is_skipped_base_pair(body, box))
            continue;
          ++distance_tests;
          const Vec2 *ends = &geometry.base_nodes[box];
          add({body, vertex, base_body, box}, distance_to_segment(ends[0], ends[1], point));
        }
      else
        {
          const int block = box - n_segments;
          if (body == base_body
                ? is_skipped_base_pair(block, vertex - 1) || is_skipped_base_pair(block, vertex)
                : is_skipped_pair(body, block))
            continue;
          ++distance_tests;
          const Vec2 *outline = &geometry.vertices[geometry.offset[block]];
          const int   n       = geometry.offset[block + 1] - geometry.offset[block];
          if (n > many_edges)
            add_near_edges(geometry, {body, vertex, block, -1}, point);
          else
            add({body, vertex, block, -1},
                contains(outline, n, point) ? 0. : distance_to_outline(outline, n, point));
        }
  }



  void ContactCandidates::add_near_edges(const Geometry         &geometry,
                                         const ContactCandidate &any_edge,
                                         const Vec2             &point)
  {
    const int first   = geometry.offset[any_edge.edge_body],
              n       = geometry.offset[any_edge.edge_body + 1] - first;
    const auto before = candidates.size();
    for (int e = first; e < first + n; ++e)
      add({any_edge.vertex_body, any_edge.vertex, any_edge.edge_body, e},
          distance_to_segment(geometry.vertices[e], geometry.vertices[geometry.next(e)], point));
    if (candidates.size() == before && contains(&geometry.vertices[first], n, point))
      add(any_edge, 0.);
  }



  void ContactCandidates::add(const ContactCandidate &pair, const double apart)
  {
    if (!(apart <= distance + margin))
      return;
    candidates.push_back(pair);
    apart_when_built.push_back(apart);
  }



  bool ContactCandidates::is_skipped_pair(const int block, const int other) const
  {
    if (block == other || has_pair(lookup.bonded, block, other))
      return true;
    if (!lookup.bedrock.empty() && lookup.bedrock[block] && lookup.bedrock[other])
      return true;
    const bool is_awake =
      lookup.awake.empty() ||
      std::max(lookup.awake[block], lookup.awake[other]) >= needed(block, other);
    return !is_awake && are_neighbours(block, other);
  }



  bool ContactCandidates::are_neighbours(const int block, const int other) const
  {
    return !neighbour_offset.empty() &&
           std::binary_search(neighbours.begin() + neighbour_offset[block],
                              neighbours.begin() + neighbour_offset[block + 1],
                              other);
  }



  Awake ContactCandidates::needed(const int block, const int other) const
  {
    const bool meets_bedrock =
      !lookup.bedrock.empty() && lookup.bedrock[block] != lookup.bedrock[other];
    return meets_bedrock ? Awake::to_all : Awake::to_blocks;
  }



  bool ContactCandidates::is_first_look(const int body, const int other) const
  {
    if (was_awake.empty())
      return false;
    if (body == base_body || other == base_body)
      return was_awake[std::max(body, other)] != Awake::to_all;
    return std::max(was_awake[body], was_awake[other]) < needed(body, other) &&
           are_neighbours(body, other);
  }



  bool ContactCandidates::is_skipped_base_pair(const int block, const int segment) const
  {
    const bool is_awake = lookup.awake.empty() || lookup.awake[block] == Awake::to_all;
    return is_awake ? has_pair(lookup.bonded_base, block, segment)
                    : has_first(lookup.bonded_base, block);
  }
} // namespace hybrid::dda
