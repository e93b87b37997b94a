// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/dda/geometry/surface_valley.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    /// From one edge to the one after it, with the rock on their right.
    double rise(const Vec2 &edge, const Vec2 &next)
    {
      const double sine = cross(edge, next) / (edge.norm() * next.norm());
      if (edge.dot(next) > 0.)
        return std::max(0., sine);
      return sine > 0. ? 1. : 0.;
    }
  } // namespace



  std::array<RisingEdge, 2> rising_edges(const Geometry &geometry, const int body, const int edge)
  {
    const bool on_foundation = body == foundation_body;
    const auto along         = [&](const int e) {
      return Vec2(position(geometry, body, second_end(geometry, body, e)) -
                  position(geometry, body, e));
    };
    const int last = static_cast<int>(geometry.foundation_nodes.size()) - 2;
    const int after =
      on_foundation ? (edge < last ? edge + 1 : -1) : end_place(geometry, body, edge);
    std::array<RisingEdge, 2> found{{{edge_before(geometry, body, edge)}, {after}}};
    // Outlines have the rock on their left.
    if (found[0].edge >= 0)
      found[0].sine = on_foundation ? rise(along(found[0].edge), along(edge))
                                    : rise(-along(edge), -along(found[0].edge));
    if (found[1].edge >= 0)
      found[1].sine = on_foundation ? rise(along(edge), along(found[1].edge))
                                    : rise(-along(found[1].edge), -along(edge));
    return found;
  }
} // namespace hybrid::dda
