// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_passage.h>
#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/dda/geometry/polygon.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    double cross_of(const Vec2 &a, const Vec2 &b)
    {
      return a.x() * b.y() - a.y() * b.x();
    }
  } // namespace


  ContactPassage::ContactPassage(const Geometry       &all,
                                 const StepMotion     &of_step,
                                 const PairTolerances &pair_tolerances)
    : geometry(all)
    , motion(of_step)
    , pairs(pair_tolerances)
  {}



  bool ContactPassage::takes(const ContactCandidate &pair) const
  {
    const Vec2 way = relative_displacement(pair);
    if (!(way.norm() > pairs.of(pair.vertex_body, pair.edge_body).reach))
      return false;
    if (!is_corner(pair))
      return false;
    const Vec2 &from = position(geometry, pair.vertex_body, pair.vertex);
    return is_surface(geometry, pair.edge_body) ? goes_behind_edge(pair, from, from + way)
                                                : goes_into_block(pair, from, from + way);
  }



  bool ContactPassage::is_corner(const ContactCandidate &pair) const
  {
    if (is_surface(geometry, pair.vertex_body))
      return true;
    const Vec2 &place = geometry.vertices[pair.vertex];
    const Vec2  in    = place - geometry.vertices[geometry.previous(pair.vertex)];
    const Vec2  out   = geometry.vertices[geometry.next(pair.vertex)] - place;
    return cross_of(in, out) > ContactTolerances::smooth_angle * in.norm() * out.norm();
  }



  Vec2 ContactPassage::relative_displacement(const ContactCandidate &pair) const
  {
    const auto displacement = [this](const int body, const int vertex) {
      return body == foundation_body ? motion.nodes[vertex] : motion.vertices[vertex];
    };
    const Vec2 mine = displacement(pair.vertex_body, pair.vertex);
    if (pair.edge_body != foundation_body)
      return mine - motion.blocks[pair.edge_body].displacement(
                      position(geometry, pair.vertex_body, pair.vertex));
    return mine - 0.5 * (motion.nodes[pair.edge] + motion.nodes[pair.edge + 1]);
  }



  bool ContactPassage::goes_behind_edge(const ContactCandidate &pair,
                                        const Vec2             &from,
                                        const Vec2             &to) const
  {
    const double depth = pairs.of(pair.vertex_body, pair.edge_body).max_depth;
    const Vec2  &a     = position(geometry, pair.edge_body, pair.edge);
    const Vec2   along =
      position(geometry, pair.edge_body, second_end(geometry, pair.edge_body, pair.edge)) - a;
    const double side  = pair.edge_body == foundation_body ? 1. : -1.; // of the outward normal
    const double first = side * cross_of(along, from - a), last = side * cross_of(along, to - a);
    const double length = along.norm();
    if (first < 0. || last >= -depth * length)
      return false;
    const Vec2   crossing = from + first / (first - last) * (to - from);
    const double place    = along.dot(crossing - a);
    return place >= 0. && place <= length * length;
  }



  bool ContactPassage::goes_into_block(const ContactCandidate &pair,
                                       const Vec2             &from,
                                       const Vec2             &to) const
  {
    const int    block = pair.edge_body;
    const double depth = pairs.of(pair.vertex_body, block).max_depth;
    const int    begin = geometry.offset[block], n = geometry.offset[block + 1] - begin;
    const Vec2  *outline = &geometry.vertices[begin];
    const Vec2   way     = to - from;
    const auto   is_deep = [&](const double part) {
      const Vec2 place = from + part * way;
      return contains(outline, n, place) && distance_to_outline(outline, n, place) > depth;
    };
    if (contains(outline, n, from))
      return false;
    if (is_deep(1.))
      return true;
    // Through it: the middles between places where the way crosses the outline, a corner twice.
    std::vector<double> crossings;
    for (int k = 0; k < n; ++k)
      {
        constexpr double slack = 1e-9; // of an edge and of the way: no crossing is lost at a corner
        const Vec2      &a     = outline[k];
        const Vec2       along = outline[(k + 1) % n] - a;
        const double     area  = cross_of(way, along);
        if (area == 0.)
          continue;
        const double part  = cross_of(a - from, along) / area,
                     place = cross_of(a - from, way) / area;
        if (part > -slack && part < 1. + slack && place > -slack && place < 1. + slack)
          crossings.push_back(part);
      }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); ++k)
      if (is_deep(0.5 * (crossings[k] + crossings[k + 1])))
        return true;
    return false;
  }
} // namespace hybrid::dda
