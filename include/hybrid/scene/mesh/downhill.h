// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

namespace hybrid::scene
{
  /**
   * Sign of x downhill: towards the lower one of the two ends of the line sliding_surface, or of
   * the line ground if there is none. 0 if it is level, within a millionth of its width, or if
   * there is neither.
   */
  double downhill_sign(const SectionMesh &mesh);
} // namespace hybrid::scene
