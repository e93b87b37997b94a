// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/base_memory.h>

namespace hybrid::continuum
{
  void take_back_base_work(const Newmark  &newmark,
                           const double    dt,
                           const Vec2     &moved,
                           const Vec2     &change,
                           ContinuumState &state)
  {
    if (newmark.filter == 0.)
      return;
    const double taken =
      newmark.filter_in(dt, state.last_step) * state.base_force_change.dot(moved);
    state.energy.input_work -= taken;
    state.energy.integration_loss -= taken;
    const double kept       = (1. - Newmark::memory) * Newmark::remembered_in(dt, state.last_step);
    state.base_force_change = kept * state.base_force_change + Newmark::memory * change;
  }
} // namespace hybrid::continuum
