// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/contact/contact_candidates.h>
#include <hybrid/dda/contact/displacement_spread.h>
#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/dda/geometry/polygon.h>

#include <algorithm>
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


  ContactCandidates::ContactCandidates(const PairTolerances &pair_tolerances, const double margin_)
    : pairs(pair_tolerances)
    , margin(margin_)
    , skin(margin_)
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
    if (given.bonded == skipped.bonded && given.joint_edges == skipped.joint_edges &&
        given.surface == skipped.surface && given.scope == skipped.scope &&
        given.held_off == skipped.held_off && given.outline == skipped.outline)
      return;
    skipped = given;
    lookup  = given;
    for (const auto &[a, b] : given.bonded)
      lookup.bonded.emplace_back(b, a);
    std::sort(lookup.bonded.begin(), lookup.bonded.end());
    std::sort(lookup.joint_edges.begin(), lookup.joint_edges.end());
    std::sort(lookup.surface.begin(), lookup.surface.end());
    is_outdated = true;
  }



  bool ContactCandidates::update(const Geometry &geometry)
  {
    const double moved   = movement(geometry.vertices, geometry.foundation_nodes);
    const bool   is_good = moved <= 0.5 * margin; // false for NaN
    if (!is_good)
      build(geometry, margin);
    wake(is_good ? moved : 0.);
    return !is_good;
  }



  bool ContactCandidates::list_for(const Geometry          &geometry,
                                   const std::vector<Vec2> &vertices,
                                   const std::vector<Vec2> &nodes,
                                   const double             way)
  {
    // Two points that meet on their ways were at most twice the movement apart.
    const double distance = pairs.narrowest().search_distance();
    if (movement(vertices, nodes) <= 0.5 * (distance + skin))
      return false;
    build(geometry, std::max(margin, 2. * way - distance));
    return true;
  }



  double ContactCandidates::movement(const std::vector<Vec2> &vertices,
                                     const std::vector<Vec2> &nodes) const
  {
    if (is_outdated || vertices.size() != built_vertices.size() ||
        nodes.size() != built_nodes.size())
      return std::numeric_limits<double>::infinity();
    DisplacementSpread spread;
    spread.add(vertices, built_vertices);
    spread.add(nodes, built_nodes);
    return spread.half_diagonal();
  }



  void ContactCandidates::wake(const double moved)
  {
    if (moved == awake_for)
      return;
    awake_for = moved;
    awake_pairs.clear();
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (apart_when_built[i] - 2. * moved <= search_distance(candidates[i]) ||
          std::binary_search(kept_awake.begin(), kept_awake.end(), candidates[i]))
        awake_pairs.push_back(candidates[i]);
  }



  void ContactCandidates::keep_awake(const std::vector<ContactCandidate> &held)
  {
    if (held == kept_awake)
      return;
    kept_awake.assign(held.begin(), held.end());
    awake_for = -1.;
  }



  void ContactCandidates::build(const Geometry &geometry, const double wide)
  {
    skin = wide;
    built_vertices.assign(geometry.vertices.begin(), geometry.vertices.end());
    built_nodes.assign(geometry.foundation_nodes.begin(), geometry.foundation_nodes.end());
    is_outdated    = false;
    awake_for      = -1.;
    distance_tests = 0;

    first_bedrock = geometry.bedrock.first_block;
    list_boxes(geometry);
    grid.build(boxes);

    candidates.clear();
    apart_when_built.clear();
    for (int i = 0; i < static_cast<int>(geometry.foundation_nodes.size()); ++i)
      add_candidates(geometry, foundation_body, i);
    for (int v = 0; v < static_cast<int>(geometry.vertices.size()); ++v)
      if (geometry.block_of[v] < first_bedrock ||
          geometry.bedrock.next[v] != BedrockSurface::inside)
        add_candidates(geometry, geometry.block_of[v], v);
    add_kept();
  }



  bool ContactCandidates::lists_edges(const Geometry &geometry, const int body)
  {
    return is_surface(geometry, body) ||
           geometry.offset[body + 1] - geometry.offset[body] > many_edges;
  }



  void ContactCandidates::add_kept()
  {
    for (const ContactCandidate &pair : kept_awake)
      {
        const auto place = std::lower_bound(candidates.begin(), candidates.end(), pair);
        if (place != candidates.end() && *place == pair)
          continue;
        apart_when_built.insert(apart_when_built.begin() + (place - candidates.begin()), 0.);
        candidates.insert(place, pair);
      }
  }



  void ContactCandidates::list_boxes(const Geometry &geometry)
  {
    const auto widest = [this](const int body) { return pairs.of(body).search_distance() + skin; };
    boxes.clear();
    bodies.clear();
    for (int i = 0; i + 1 < static_cast<int>(geometry.foundation_nodes.size()); ++i)
      {
        boxes.push_back(box_around(&geometry.foundation_nodes[i], 2, widest(foundation_body)));
        bodies.push_back({foundation_body, i});
      }
    const int n_mass = std::min(first_bedrock, geometry.n_blocks());
    for (int b = 0; b < n_mass; ++b)
      {
        boxes.push_back(box_around(&geometry.vertices[geometry.offset[b]],
                                   geometry.offset[b + 1] - geometry.offset[b],
                                   widest(b)));
        bodies.push_back({b, -1});
      }
    for (int v = geometry.offset[n_mass]; v < static_cast<int>(geometry.vertices.size()); ++v)
      if (geometry.bedrock.next[v] != BedrockSurface::inside)
        {
          const Vec2 ends[2]{geometry.vertices[v], geometry.vertices[geometry.next(v)]};
          boxes.push_back(box_around(ends, 2, widest(geometry.block_of[v])));
          bodies.push_back({geometry.block_of[v], v});
        }
  }



  void ContactCandidates::add_candidates(const Geometry &geometry, const int body, const int vertex)
  {
    found.clear();
    grid.find(position(geometry, body, vertex), found);
    std::sort(found.begin(), found.end()); // in the order of bodies
    for (const int box : found)
      if (!is_surface(geometry, bodies[box].first))
        add_block(geometry, body, vertex, bodies[box].first);
      else if (!is_surface(geometry, body))
        add_edge_of_surface(geometry, body, vertex, box);
  }



  void ContactCandidates::add_edge_of_surface(const Geometry &geometry,
                                              const int       block,
                                              const int       vertex,
                                              const int       number)
  {
    const auto [body, edge] = bodies[number];
    if (is_skipped_edge({block, body, edge}))
      return;
    ++distance_tests;
    add({block, vertex, body, edge},
        distance_to_segment(position(geometry, body, edge),
                            position(geometry, body, second_end(geometry, body, edge)),
                            geometry.vertices[vertex]));
  }



  void ContactCandidates::add_block(const Geometry &geometry,
                                    const int       body,
                                    const int       vertex,
                                    const int       block)
  {
    if (!is_surface(geometry, body))
      {
        if (is_skipped_pair(body, block))
          return;
      }
    else
      for (const int edge :
           {edge_before(geometry, body, vertex), edge_after(geometry, body, vertex)})
        if (edge >= 0 && is_skipped_edge({block, body_of(geometry, body, edge), edge}))
          return;
    ++distance_tests;
    const Vec2 &point   = position(geometry, body, vertex);
    const Vec2 *outline = &geometry.vertices[geometry.offset[block]];
    const int   n       = geometry.offset[block + 1] - geometry.offset[block];
    if (lists_edges(geometry, block))
      add_near_edges(geometry, {body, vertex, block, -1}, point);
    else
      add({body, vertex, block, -1},
          contains(outline, n, point) ? 0. : distance_to_outline(outline, n, point));
  }



  void ContactCandidates::add_near_edges(const Geometry         &geometry,
                                         const ContactCandidate &any_edge,
                                         const Vec2             &point)
  {
    const int first   = geometry.offset[any_edge.edge_body],
              n       = geometry.offset[any_edge.edge_body + 1] - first;
    const auto before = candidates.size();
    for (int e = first; e < first + n; ++e)
      if (!is_joint_edge(any_edge.vertex_body, any_edge.edge_body, e))
        add({any_edge.vertex_body, any_edge.vertex, any_edge.edge_body, e},
            distance_to_segment(geometry.vertices[e], geometry.vertices[geometry.next(e)], point));
    if (candidates.size() == before && contains(&geometry.vertices[first], n, point))
      add(any_edge, 0.);
  }



  void ContactCandidates::add(const ContactCandidate &pair, const double apart)
  {
    if (!(apart <= search_distance(pair) + skin))
      return;
    candidates.push_back(pair);
    apart_when_built.push_back(apart);
  }



  bool ContactCandidates::is_skipped_pair(const int block, const int other) const
  {
    if (block == other || has_pair(lookup.bonded, block, other))
      return true;
    const bool is_awake =
      lookup.scope.empty() ||
      std::max(lookup.scope[block], lookup.scope[other]) >= ContactScope::to_blocks;
    return !is_awake && are_neighbours(block, other);
  }



  bool ContactCandidates::are_neighbours(const int block, const int other) const
  {
    return !neighbour_offset.empty() &&
           std::binary_search(neighbours.begin() + neighbour_offset[block],
                              neighbours.begin() + neighbour_offset[block + 1],
                              other);
  }



  bool ContactCandidates::is_first_activation(const int body, const int other) const
  {
    if (was_awake.empty())
      return false;
    for (const int surface : {body, other})
      if (surface == foundation_body || surface >= first_bedrock)
        {
          const int block = surface == body ? other : body;
          return is_held_off(block) && was_awake[block] != ContactScope::to_all;
        }
    return std::max(was_awake[body], was_awake[other]) < ContactScope::to_blocks &&
           are_neighbours(body, other);
  }



  bool ContactCandidates::is_joint_edge(const int block, const int body, const int edge) const
  {
    return !lookup.joint_edges.empty() && std::binary_search(lookup.joint_edges.begin(),
                                                             lookup.joint_edges.end(),
                                                             BondedEdge{block, body, edge});
  }



  bool ContactCandidates::is_held_off(const int block) const
  {
    return !lookup.held_off.empty() && lookup.held_off[block];
  }



  bool ContactCandidates::is_skipped_edge(const BondedEdge &pair) const
  {
    const bool is_awake = lookup.scope.empty() || lookup.scope[pair.block] == ContactScope::to_all;
    return (!is_awake && is_held_off(pair.block)) ||
           std::binary_search(lookup.surface.begin(), lookup.surface.end(), pair);
  }
} // namespace hybrid::dda
