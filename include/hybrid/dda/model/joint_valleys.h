// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>

namespace hybrid::dda
{
  /**
   * Set Joint::valley of the mass's joints: how steeply the ground, or the outline of one of two
   * blocks, rises beyond an end of the joint. What slides there sinks into an edge that its joint
   * knows nothing of. An edge that another joint of the same two bodies bonds bears it.
   */
  void set_joint_valleys(Model &model);
} // namespace hybrid::dda
