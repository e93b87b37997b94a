// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid
{
  /// How a run ended.
  enum class RunStatus
  {
    finished,
    no_convergence, ///< a step failed at the smallest allowed size
    energy_limit,   ///< the energy audit does not close, with a checkpoint
    no_equilibrium, ///< the slope cannot stand, and the scene asks for one that does
    interrupted     ///< by the user, with a checkpoint if the static stage was over
  };
} // namespace hybrid
