// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/statics/static_steps.h>

namespace hybrid::dda
{
  /**
   * Let the blocks settle under gravity on the fixed foundation, strengths active
   * (take_static_steps()). The forces on the foundation become DdaState::static_force.
   *
   * @param held friction and bonds are unlimited while the blocks settle.
   * @param watch may be empty.
   * @param resets_softening strengths are those of the slope as it stands: slip takes nothing of
   *   them while it settles, and slip and softening of joints count from the state at rest.
   */
  StaticResult settle(const Model       &model,
                      DdaState          &state,
                      bool               held             = false,
                      const StaticWatch &watch            = {},
                      bool               resets_softening = false);
} // namespace hybrid::dda
