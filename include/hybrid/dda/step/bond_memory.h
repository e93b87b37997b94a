// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/dda/springs/springs.h>

namespace hybrid::dda
{
  // What bonds between blocks put into the blocks' memories of accelerations (Newmark::filter).
  // Memories turn with their blocks. Two blocks that a bond holds turn by different angles where
  // the body vibrates, so that the shares of that bond, equal and opposite before, would get a
  // resultant, which changes the momentum of the body. So the bond's share turns by the mean of
  // both angles, on both sides. A base does not turn, and has no memory: the share of its bonds
  // turns with the block.

  /// Bring JointState::force_change of joint @p number of the step to the end of the solved step.
  /// The geometry of @p state is that where the step began. @param kept of the old memory, see
  /// Newmark
  void remember_bond_force(const Model   &model,
                           const Springs &springs,
                           const Trial   &trial,
                           double         kept,
                           int            number,
                           DdaState      &state);

  /// Work of a base that moves as prescribed with what its bonds put into the blocks' memories in
  /// the step before [J/m].
  double remembered_base_work(const Model    &model,
                              const Springs  &springs,
                              const Trial    &trial,
                              const DdaState &state);

  /// What turning a block's memory with the block has added to the bonds' shares of it [N/m], after
  /// remember_bond_force() of all joints.
  Vec2
  turned_beyond_bonds(const Springs &springs, const Trial &trial, const DdaState &state, int block);
} // namespace hybrid::dda
