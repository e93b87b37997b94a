// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/contact_state.h>
#include <hybrid/dda/model/state.h>

namespace hybrid::dda
{
  /// What a spring does that is in this state.
  inline Condition condition_of(const SpringState &now)
  {
    if (now.state == ContactState::open)
      return Condition::open;
    if (now.state == ContactState::locked)
      return Condition::sticks;
    if (now.shear == 0.)
      return Condition::law; // no strength, no direction
    return now.shear > 0. ? Condition::slides_forward : Condition::slides_backward;
  }
} // namespace hybrid::dda
