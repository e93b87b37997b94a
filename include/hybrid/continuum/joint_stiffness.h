// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::continuum
{
  /// Elastic joints along bedding planes; per area of the plane.
  struct JointStiffness
  {
    double normal = 0.; ///< k_n [Pa/m]
    double shear  = 0.; ///< k_s [Pa/m]
  };
} // namespace hybrid::continuum
