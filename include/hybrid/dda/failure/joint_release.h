// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

namespace hybrid::dda
{
  /**
   * Contacts between the bodies of joints that have been released since the last call take their
   * load over: they press from the overlap they have, but at most from that of the joint's springs
   * and with no more than the force of one of these (stress_free_gap), so they store no more than
   * the joint did: a short edge of large blocks is soft, and overlaps far under little load. From
   * zero, blocks would first have to sink onto each other, without friction on the way. Contacts
   * that already press stay as they are. With an initial stress the springs were stretched where
   * blocks lay as drawn (JointState::drawn_gap), and contacts press from as far off.
   *
   * To be called after the contact search of a step. Sets JointState::handed_over.
   */
  void hand_over_released_joints(const Model &model, DdaState &state);
} // namespace hybrid::dda
