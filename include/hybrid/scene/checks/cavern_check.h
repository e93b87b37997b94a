// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /**
   * Check the walls of closed caverns, holes in the bedrock of @p mesh: they are on a line as all
   * of its boundary, and finite elements below blocks have none, as their surface is one path from
   * side to side.
   *
   * @throws InputError for the first wall that is not so, with its extent [m] and what to do.
   */
  void check_caverns(const SectionMesh &mesh, const SceneParameters &scene);
} // namespace hybrid::scene
