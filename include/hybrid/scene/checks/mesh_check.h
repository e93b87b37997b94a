// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /**
   * Check that @p mesh has what the models of @p scene need:
   *   - the continuum: bedrock, base, left, right, and every bedding plane named as a joint;
   *   - blocks: sliding_mass; both together: sliding_surface;
   *   - cells and blocks that are neither inverted nor of zero area;
   *   - every boundary edge of the bedrock on one of the lines base, left, right, ground,
   *     sliding_surface, and those lines on the boundary; bedding planes inside; no caverns below
   *     blocks (check_caverns());
   *   - blocks of the mesh sharing their nodes with the bedrock along the sliding surface;
   *   - what check_geometry() looks at.
   *
   * @throws InputError for the first of them that fails, with coordinates [m].
   */
  void check_section_mesh(const SectionMesh &mesh, const SceneParameters &scene);
} // namespace hybrid::scene
