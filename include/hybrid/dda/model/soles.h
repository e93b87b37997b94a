// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <vector>

namespace hybrid::dda
{
  struct Model;

  /// A point of the ground: between two nodes of the foundation, or two vertices of a block of the
  /// bedrock.
  struct SoleGround
  {
    bool   base  = false; ///< else vertices
    int    first = -1, second = -1;
    double fraction = 0.; ///< of the path from the first to the second
  };


  /// An edge of a block of the mass that lies on the foundation or on the bedrock's blocks before
  /// the first step: with its middle, or, where it bridges a dip, with another of its points.
  struct Sole
  {
    int        first, second; ///< vertices of the block, counter-clockwise
    double     fraction;      ///< of the path from the first to the second: the point that slides
    SoleGround ground;        ///< what that point lies on
    Vec2       position;      ///< of that point, as drawn [m]
    double     length;        ///< [m]
    Vec2       below[2];      ///< points of the ground that are nearest to its ends [m]
  };


  /// All soles of the mass, in the order of their blocks.
  std::vector<Sole> find_soles(const Model &model);
} // namespace hybrid::dda
