// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

#include <string>

namespace hybrid::scene
{
  /// What to say of blocks of @p mesh that lie along each other but share no whole edge, as bricks
  /// of a wall in running bond do: joints bond whole edges only. Empty if there are none.
  std::string partly_shared_edges(const SectionMesh &mesh);
} // namespace hybrid::scene
