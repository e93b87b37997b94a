// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/statics/static_steps.h>
#include <hybrid/dda/step/open_close_iteration.h>

namespace hybrid::dda
{
  /// Relative residual at rest, of forces and of inertial forces at the end of a step [-].
  constexpr double static_target = 1e-9;

  /// Take velocities and accelerations away.
  void stop_blocks(DdaState &state);

  /// The open-close iterations of the step under way, and what was done before. Both arguments must
  /// outlive it.
  OpenCloseIteration::Watch watch_of_step(const StaticWatch &watch, const StaticResult &result);

  /// True if a joint of the mass that holds has slipped by a tenth of its length, or a block has
  /// sheared by as much: the mass moves, and farther on the joint would pull askew.
  bool slides_or_shears(const Model &problem, const DdaState &state);
} // namespace hybrid::dda
