// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * Water that can be computed with but is hardly meant, one sentence each: water that neither
   * changes a material nor reaches a block, a phreatic line beside the section, water far above it,
   * total densities where Water/Method = paper lets no pore pressure act, and a level that differs
   * from event to event. What counts of a phreatic line is its part over the section.
   */
  std::vector<std::string> water_warnings(const SectionMesh &mesh, const SceneParameters &scene);
} // namespace hybrid::scene
