// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/maxwell_body.h>

namespace hybrid::continuum
{
  /// Damping of the rock.
  struct RockDamping
  {
    double      mass      = 0.; ///< alpha_M [1/s]
    double      stiffness = 0.; ///< beta_K [s]
    MaxwellBody body;
  };
} // namespace hybrid::continuum
