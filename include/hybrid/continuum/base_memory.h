// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum_state.h>
#include <hybrid/scene/newmark.h>

namespace hybrid::continuum
{
  /**
   * A Newmark::filter takes a part of the change of all forces back, also of the one that moves a
   * base. That part acts on the base, too: its work is off the input work, and off what the
   * integration has lost. To be called once per step, before the step's size is remembered.
   *
   * @param moved by the base in the step [m]. @param change of the force by which it moves the
   * model, less the contacts' part [N/m]
   */
  void take_back_base_work(const Newmark  &newmark,
                           double          dt,
                           const Vec2     &moved,
                           const Vec2     &change,
                           ContinuumState &state);
} // namespace hybrid::continuum
