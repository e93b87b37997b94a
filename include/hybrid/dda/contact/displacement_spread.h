// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/geometry.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hybrid::dda
{
  /// Box around displacements of points: how far they move beside what they move together. NaN
  /// spoils it for good.
  class DisplacementSpread
  {
  public:
    void add(const std::vector<Vec2> &displacements)
    {
      for (const Vec2 &displacement : displacements)
        add(displacement.x(), displacement.y());
    }

    /// Of points from @p then to @p now [m].
    void add(const std::vector<Vec2> &now, const std::vector<Vec2> &then)
    {
      for (std::size_t i = 0; i < now.size(); ++i)
        add(now[i].x() - then[i].x(), now[i].y() - then[i].y());
    }

    /// No displacement is farther from the box's middle [m].
    double half_diagonal() const
    {
      return 0.5 * std::hypot(upper_x - lower_x, upper_y - lower_y) + 0. * sum;
    }

  private:
    double lower_x = 0., upper_x = 0., lower_y = 0., upper_y = 0., sum = 0.;
    bool   is_empty = true;

    void add(const double x, const double y)
    {
      if (is_empty)
        {
          lower_x = upper_x = x;
          lower_y = upper_y = y;
          is_empty          = false;
        }
      lower_x = std::min(lower_x, x);
      upper_x = std::max(upper_x, x);
      lower_y = std::min(lower_y, y);
      upper_y = std::max(upper_y, y);
      sum += x + y;
    }
  };
} // namespace hybrid::dda
