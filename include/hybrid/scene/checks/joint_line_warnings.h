// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * Lines joint_<suffix> that do less than their name says, one sentence each: edges to which no
   * other block lies, as on the sliding surface, and edges that meet others in part of which only
   * one side is named, so that contacts with the other side have the material of the block.
   */
  std::vector<std::string> joint_line_warnings(const SectionMesh     &mesh,
                                               const SceneParameters &scene);
} // namespace hybrid::scene
