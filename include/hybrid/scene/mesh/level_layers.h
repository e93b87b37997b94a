// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

namespace hybrid::scene
{
  /**
   * Whether all edges between cells of different regions of the bedrock are level, within 1 degree:
   * it is of one region, or its layers have no corners within it, where strains could grow without
   * bound.
   */
  bool has_level_layers(const SectionMesh &mesh);
} // namespace hybrid::scene
