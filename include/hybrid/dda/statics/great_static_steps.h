// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/statics/static_steps.h>

#include <vector>

namespace hybrid::dda
{
  /// Blocks of the sliding mass that joints hold, by way of others, to the ground, whatever has
  /// failed; one entry for each. @param present only these are looked at, likewise
  std::vector<char> held_to_ground(const Model &model, const std::vector<char> &present);


  /// True if joints that have not failed hold every block of the sliding mass, by way of others, to
  /// the ground.
  bool is_whole(const Model &model, const DdaState &state);


  /**
   * Bring a whole mass to rest in a few steps so great that inertia hardly counts, with full steps
   * of the open-close iteration: joints hold the blocks beside each other, so a step may move them
   * as far as they settle.
   *
   * @return false, with the state as it was, if the steps do not converge, a joint fails, or slips
   * by a tenth of its length: the way matters then, and small steps have to find it.
   */
  bool take_great_steps(const Model       &problem,
                        DdaState          &state,
                        const StaticWatch &watch,
                        StaticResult      &result);
} // namespace hybrid::dda
