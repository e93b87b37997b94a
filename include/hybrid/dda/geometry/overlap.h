// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/geometry.h>

namespace hybrid::dda
{
  /// How deep a block is in another one, or in the ground.
  struct Overlap
  {
    double part  = 0.; ///< depth over the size (root of the area) of the smaller block [-]
    double depth = 0.; ///< of the deepest place below the outline of the body it is in [m]
    double size  = 0.; ///< of the smaller block [m]
    int    block = -1; ///< the block; -1: nothing overlaps
    int    other = -1; ///< the body that it overlaps: a block or foundation_body
    Vec2   place = Vec2::Zero(); ///< [m]
  };


  /**
   * The deepest overlap of blocks with each other and with the foundation, as a part of their size.
   *
   * Found from where the bodies are alone, not from their contacts, so that it tells what these
   * have missed. Looked at are corners, middles of edges and of blocks, and places of the
   * foundation. Blocks of a bedrock among each other are left out. O(blocks + places).
   */
  Overlap deepest_overlap(const Geometry &geometry);
} // namespace hybrid::dda
