// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace hybrid
{
  /// A point or vector in the vertical section: x horizontal (uphill positive in slopes), y up.
  using Vec2 = Eigen::Vector2d;

  /// z component of the cross product a x b.
  inline double cross(const Vec2 &a, const Vec2 &b)
  {
    return a.x() * b.y() - a.y() * b.x();
  }
} // namespace hybrid
