// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/geometry.h>

#include <array>

namespace hybrid::dda
{
  /// An edge that follows another one on an outline, or on the surface of the ground.
  struct RisingEdge
  {
    int    edge = -1; ///< its first vertex or foundation node; -1: there is none
    double sine = 0.; ///< of the angle by which it rises from the other one's line [-]: 0 where it
                      ///< goes on straight or falls, 1 from a right angle on
  };

  /// The edges before and after one of @p body, as they rise from it into what lies on them: a
  /// convex outline rises nowhere.
  /// @param body foundation_body, a block, or one of the bedrock of which @p edge is on the surface
  std::array<RisingEdge, 2> rising_edges(const Geometry &geometry, int body, int edge);
} // namespace hybrid::dda
