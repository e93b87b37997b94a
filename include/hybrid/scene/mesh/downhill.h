// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

#include <vector>

namespace hybrid::scene
{
  /// Where a line begins and ends along x [m].
  struct LineEnds
  {
    Vec2 left  = Vec2::Zero();
    Vec2 right = Vec2::Zero();

    /// Sign of x towards the lower one; 0 if they are level, within a millionth of their distance
    /// along x.
    double downhill() const;
  };


  /// The ends of a line that ends in a wall.
  enum class WallEnd
  {
    foot, ///< of what lies on the line
    top   ///< of the line itself: a surface
  };


  /// Points with the smallest and the largest x, of those at one x what @p end says; both (0, 0)
  /// without points.
  LineEnds ends_of(const std::vector<Vec2> &points, WallEnd end);

  /// Ends of the line sliding_surface, or of the line ground if there is none; both (0, 0) without
  /// either.
  LineEnds ends_of_surface(const SectionMesh &mesh);

  /// Sign of x downhill at a level stretch of the surface: towards the lower one of the surface's
  /// two ends. 0 if they are level, and where the stretch is the floor of a valley or the top of a
  /// hill: both ends above it, or both below.
  double downhill_beside(const LineEnds &stretch, const SectionMesh &mesh);

  /// Sign of x towards the lower end of what the line mass_surface has between two places along x
  /// [m], as of a slope on level ground; 0 if that is level, or if there is none.
  double downhill_above(double left, double right, const SectionMesh &mesh);

  /// Sign of x downhill of a whole scene, as of one without blocks: towards the lower one of the
  /// surface's two ends; where they are level, downhill_above() all of it.
  double downhill_sign(const SectionMesh &mesh);
} // namespace hybrid::scene
