// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/dda/model/state.h>

namespace hybrid::coupling
{
  /// All mutable state of a run: copied for roll-back, written for restart.
  struct CoupledState
  {
    dda::DdaState             blocks;
    continuum::ContinuumState continuum;

    /// [s]
    double time() const
    {
      return continuum.time;
    }

    /// Of both parts, which add up their steps: the clock's, so that they do not drift.
    void set_time(const double time)
    {
      blocks.time = continuum.time = time;
    }
  };

  /// All members, for the checkpoint.
  void serialize(restart::Archive &archive, CoupledState &state);
} // namespace hybrid::coupling
