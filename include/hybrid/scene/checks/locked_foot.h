// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

#include <string>

namespace hybrid::scene
{
  /**
   * Places where blocks that rest on the sliding surface end in a kink beyond which the ground
   * falls by 3 degrees less or more, or rises by 30 degrees at most: one sentence for the sharpest
   * of them, with its coordinates; empty if there is none. Limit equilibrium lets a slip line come
   * out there; blocks cannot leave it without climbing, so that the mass is held whatever its
   * strength.
   */
  std::string locked_foot(const SectionMesh &mesh);
} // namespace hybrid::scene
