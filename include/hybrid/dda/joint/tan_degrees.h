// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace hybrid::dda
{
  inline double tan_degrees(const double angle)
  {
    return std::tan(angle * M_PI / 180.);
  }
} // namespace hybrid::dda
