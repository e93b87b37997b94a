// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /**
   * Check what a section drawn by hand gets wrong, of a mesh whose cells and blocks are sound:
   *   - its unit (unit_check.h);
   *   - the bedrock is one piece, bedding planes do not cross;
   *   - a meshed mass has a block at every edge of the sliding surface;
   *   - blocks overlap neither each other nor the bedrock (by 0.001 of their size: coordinates are
   *     rounded), and none is below a rigid base, which is one polyline.
   *
   * @throws InputError for the first of them that fails, with coordinates [m].
   */
  void check_geometry(const SectionMesh &mesh, const SceneParameters &scene);
} // namespace hybrid::scene
