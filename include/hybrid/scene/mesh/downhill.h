// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

namespace hybrid::scene
{
  /**
   * Sign of x downhill: towards the lower one of the two ends of the line sliding_surface, or of
   * the line ground if there is none. Where it is level, within a millionth of its width, towards
   * the lower end of the line mass_surface, as of a slope on level ground. 0 if that is level, too,
   * or if there is none.
   */
  double downhill_sign(const SectionMesh &mesh);
} // namespace hybrid::scene
