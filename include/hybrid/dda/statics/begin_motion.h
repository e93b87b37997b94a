// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

namespace hybrid::dda
{
  /// What the static stage held with unlimited strengths.
  struct HeldParts
  {
    bool mass   = false;
    bool planes = false; ///< bedding planes of a bedrock of blocks
  };


  /**
   * From now on the bedrock's blocks bear what the springs of @p state put on them, and feel
   * changes only; and set all accelerations.
   *
   * @param held with unlimited strengths: the bedrock bears what was held.
   * Contacts act with the forces at a step's end, bonds with those at both ends: bonds are let go
   * over the first step, and begin with what they held.
   */
  void begin_motion(const Model &model, DdaState &state, const HeldParts &held);


  /// The same, and the foundation's forces, after joints of the bedrock were given tractions.
  void store_static_reactions(const Model &model, DdaState &state, const HeldParts &held);
} // namespace hybrid::dda
