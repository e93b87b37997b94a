// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/dda/state.h>

namespace hybrid::coupling
{
  /// All mutable state of a run: copied for roll-back, written for restart.
  struct CoupledState
  {
    double                    time = 0.; ///< [s]
    dda::DdaState             blocks;
    continuum::ContinuumState continuum;
  };

  /// All members, for the checkpoint.
  void serialize(restart::Archive &archive, CoupledState &state);
} // namespace hybrid::coupling
