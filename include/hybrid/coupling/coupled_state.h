// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/dda/model/state.h>

#include <vector>

namespace hybrid::coupling
{
  /// Free-field columns beside bedrock of blocks, one after the other: values of their nodes.
  struct ColumnState
  {
    std::vector<double> displacement;   ///< [m]
    std::vector<double> velocity;       ///< [m/s]
    std::vector<double> acceleration;   ///< [m/s2]
    std::vector<double> change;         ///< of the acceleration that is remembered [m/s2]; empty
                                        ///< without a Newmark::filter
    double              last_step = 0.; ///< of that change [s]; 0: none
    std::vector<double> branches;       ///< MaxwellState::strain [m]; empty without Maxwell damping
    std::vector<continuum::SlipState> slip; ///< of each column's joints; empty: none may slip
    std::vector<double> rest;      ///< tractions of all joints at rest, normal (tension positive)
                                   ///< and shear [Pa]; empty like slip
    std::vector<char> rest_failed; ///< joints that have lost cohesion and tensile strength there
  };


  /// All mutable state of a run: copied for roll-back, written for restart. What a scene has not
  /// is empty.
  struct CoupledState
  {
    double                    time = 0.; ///< [s]
    dda::DdaState             blocks;
    continuum::ContinuumState continuum; ///< finite elements
    ColumnState               columns;

    /// The clock's time, for the parts as well: they add up their steps, and would drift.
    void set_time(const double now)
    {
      time = blocks.time = continuum.time = now;
    }
  };

  /// All members, for the checkpoint.
  void serialize(restart::Archive &archive, CoupledState &state);
} // namespace hybrid::coupling
