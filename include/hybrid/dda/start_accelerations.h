// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs.h>

namespace hybrid::dda
{
  /// Springs of @p state and what they carry while nothing moves.
  Springs springs_at_rest(const Model &model, const DdaState &state);


  /**
   * Set the accelerations of all blocks from the forces in @p state (stresses,
   * joints, listed contacts, weight), so that motion starts with the right
   * first step: zero at rest, -g in free fall, the excess over the strength
   * where a mass was held until now.
   */
  void start_accelerations(const Model &model, DdaState &state);


  /**
   * From now on the bedrock's blocks bear what the springs of @p state put on them, and feel
   * changes only; and set all accelerations.
   *
   * @param held the mass was @p held with unlimited strengths: the bedrock bears what it held.
   * Contacts act with the forces at a step's end, bonds with those at both ends: bonds are let go
   * over the first step, and begin with what they held.
   */
  void begin_motion(const Model &model, DdaState &state, bool held);


  /// The same, and the base's forces, after joints of the bedrock were given tractions.
  void bear_rest(const Model &model, DdaState &state, bool held);
} // namespace hybrid::dda
