// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>

#include <vector>

namespace hybrid::dda
{
  /// A bound on what each block of the mass settles elastically under its weight, joints as soft as
  /// blocks [m]: the height of the mass, squared, by the softest block above or below it,
  /// gamma / G (gamma: unit weight, G: shear modulus).
  std::vector<double> elastic_settlement(const Model &model);
} // namespace hybrid::dda
