// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/springs/springs.h>

namespace hybrid::dda
{
  /**
   * What the sliding mass does to all that it stands on (base or bedrock), in the springs' last
   * trial.
   *
   * Shear and normal force are sums of sizes along the surface, the integrals of its tractions;
   * on a bent surface they are no components of the resultant. Shear is positive downhill of the
   * block that bears it, so that slides that face each other do not cancel.
   */
  SurfaceForce surface_force(const Model &model, const Springs &springs);
} // namespace hybrid::dda
