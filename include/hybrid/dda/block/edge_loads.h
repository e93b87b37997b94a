// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block_motion.h>
#include <hybrid/dda/geometry/geometry.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/load_parameters.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Even tractions on free edges of blocks: dead loads, which keep size and
   * direction while the edge moves, times a factor of time that rises linearly.
   *
   * A block moves linearly in space, so an even traction works on the
   * displacement of the edge's middle only.
   */
  struct EdgeLoads
  {
    struct Edge
    {
      int  block;
      int  vertex; ///< first vertex of the edge (Geometry::vertices)
      Vec2 force;  ///< traction times initial length, to the right and up [N/m]
    };

    std::vector<Edge> edges;
    double            start     = 0.; ///< [s]
    double            rise_time = 0.; ///< [s]

    /// Part of the full load that acts at @p time [s]: 0 up to start, 1 from start + rise_time on.
    double factor(double time) const;
  };


  /// The edges in the boxes of the scene that no two blocks share and that do not lie on the line
  /// "sliding_surface".
  /// @param outlines nodes of all blocks, in the order of @p geometry.
  /// @throws InputError if a box has none.
  EdgeLoads find_edge_loads(const scene::SectionMesh            &mesh,
                            const scene::EdgeLoadParameters     &parameters,
                            const std::vector<std::vector<int>> &outlines,
                            const Geometry                      &geometry);


  /// Generalised force of the full load of one edge whose ends were at @p geometry and have moved
  /// by
  /// @p displacements (per vertex; nullptr: not at all).
  Vec6 edge_force(const EdgeLoads::Edge &edge,
                  const Geometry        &geometry,
                  const Vec2            *displacements,
                  const BlockMotion     &motion);
} // namespace hybrid::dda
