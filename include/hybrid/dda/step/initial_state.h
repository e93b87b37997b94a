// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

namespace hybrid::dda
{
  /// Blocks at rest, unstressed, joints intact.
  DdaState initial_state(const Model &model);


  /// Give the blocks of @p model their velocities; @p state keeps its places, and its kinetic
  /// energy is that of the velocities.
  void set_in_motion(const Model &model, DdaState &state);
} // namespace hybrid::dda
