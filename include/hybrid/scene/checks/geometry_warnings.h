// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * Geometry that can be computed with but is hardly meant, one sentence each with coordinates:
   * blocks that are to find their equilibrium but neither touch the base nor lie on blocks that do
   * (a gap at the surface, a mass beside the base), blocks a thousand times longer than thick,
   * corners of bonded blocks that are all but in one place, blocks that yield and are no triangles,
   * a mass that ends in a kink of the ground (locked_foot()), and a section far from the origin.
   */
  std::vector<std::string> geometry_warnings(const SectionMesh &mesh, const SceneParameters &scene);
} // namespace hybrid::scene
