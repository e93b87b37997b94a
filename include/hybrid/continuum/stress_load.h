// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/element_nodes.h>

#include <functional>
#include <vector>

namespace hybrid::continuum
{
  /// Stress in a cell, at local coordinates in [0, 1]^2: xx, yy, xy, tension positive [Pa].
  using CellStress = std::function<Eigen::Vector3d(int cell, const Vec2 &local)>;

  /// Adds @p factor int B^T sigma dA to the load of the nodes [N/m]; exact for stress that is
  /// linear in a cell.
  void add_stress_load(const ElementNodes  &nodes,
                       const CellStress    &stress,
                       double               factor,
                       std::vector<double> &load);
} // namespace hybrid::continuum
