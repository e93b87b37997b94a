// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

namespace hybrid::scene
{
  /// Node where the outline of bedrock and mass together turns inwards.
  struct ReentrantCorner
  {
    int    node;
    Vec2   position; ///< [m]
    double turn;     ///< to the right, the body to the left [rad]
    double edge[2];  ///< lengths of the outline's edges to and from it [m]
  };


  /// Those that turn by more than @p least_turn [rad].
  std::vector<ReentrantCorner> reentrant_corners(const SectionMesh &mesh, double least_turn);

  /**
   * Whether the outline of bedrock and mass together turns inwards by more than 1 degree at a node,
   * as at the toe of a slope or of a mass, or along a curve that straight edges follow: there
   * strains grow without bound, and the error of the elements falls more slowly than that of waves
   * (Williams 1952).
   */
  bool has_reentrant_corner(const SectionMesh &mesh);
} // namespace hybrid::scene
