// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <vector>

namespace hybrid::dda
{
  struct Model;
  struct SoleGround;

  /// Edges of the ground one behind the other, the ground on their left side.
  struct GroundLine
  {
    bool             base   = false; ///< the points are nodes of the foundation, else vertices
    bool             closed = false; ///< the last point is followed by the first
    std::vector<int> points;

    /// Its points where @p vertices and @p nodes are [m].
    std::vector<Vec2> places(const std::vector<Vec2> &vertices,
                             const std::vector<Vec2> &nodes) const;
  };


  /// What the mass can lie on: the surface of the bedrock's blocks and the foundation.
  std::vector<GroundLine> ground_lines(const Model &model);

  /// Number of the line that a sole lies on.
  int line_below(const std::vector<GroundLine> &lines, const SoleGround &ground);

  /// The line without its dips: a piece between two points that are not farther from each other
  /// than @p width [m], which lies on the ground's side of the straight line between them and is
  /// deeper there than a twentieth of it, as a sole that long does not lie in it. The deepest of
  /// those that overlap counts. A bend that is gentler stays.
  std::vector<Vec2> without_dips(const std::vector<Vec2> &line, double width);
} // namespace hybrid::dda
