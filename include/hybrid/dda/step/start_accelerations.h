// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

namespace hybrid::dda
{
  /**
   * Set the accelerations of all blocks from the forces in @p state (stresses,
   * joints, listed contacts, weight), so that motion starts with the right
   * first step: zero at rest, -g in free fall, the excess over the strength
   * where a mass was held until now.
   */
  void start_accelerations(const Model &model, DdaState &state);
} // namespace hybrid::dda
