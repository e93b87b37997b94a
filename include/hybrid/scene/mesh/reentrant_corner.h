// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

namespace hybrid::scene
{
  /**
   * Whether the outline of bedrock and mass together turns inwards by more than 1 degree at a node,
   * as at the toe of a slope or of a mass, or along a curve that straight edges follow: there
   * strains grow without bound, and the error of the elements falls more slowly than that of waves
   * (Williams 1952).
   */
  bool has_reentrant_corner(const SectionMesh &mesh);
} // namespace hybrid::scene
