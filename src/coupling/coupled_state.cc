// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/coupled_state.h>
#include <hybrid/restart/archive.h>

namespace hybrid::coupling
{
  void serialize(restart::Archive &archive, CoupledState &state)
  {
    auto &[time, blocks, continuum, columns] = state;
    auto &[displacement,
           velocity,
           acceleration,
           change,
           last_step,
           branches,
           slip,
           rest,
           rest_failed]                      = columns;
    archive(time, blocks, continuum, displacement, velocity, acceleration, change, last_step);
    archive(branches, slip, rest, rest_failed);
  }
} // namespace hybrid::coupling
