// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/coupled_state.h>
#include <hybrid/restart/archive.h>

namespace hybrid::coupling
{
  void serialize(restart::Archive &archive, CoupledState &state)
  {
    auto &[blocks, continuum] = state;
    archive(blocks, continuum);
  }
} // namespace hybrid::coupling
