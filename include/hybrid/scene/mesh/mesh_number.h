// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid::scene
{
  /**
   * Whether a number of a .geo file may have a value.
   *
   * gmsh makes up a range for its sliders where the file gives none: from a fifth to five times the
   * default, of a fraction from a twentieth to twenty times. Such a range bounds nothing.
   *
   * @param json the ONELAB parameter as gmsh describes it
   * @return empty, or the value and the range that the file gives
   */
  std::string outside_range(const std::string &json, double value);
} // namespace hybrid::scene
