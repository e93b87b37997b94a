// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/linear_table.h>

#include <string>

namespace hybrid::scene
{
  /// What the water below its level does: section "Water", parameter "Method".
  enum class WaterMethod
  {
    paper,     ///< nothing but the saturated materials, whose weight is as given
    submerged, ///< buoyancy of the submerged part of each block
    pressures  ///< hydrostatic pressure on all faces and in all joints; the bedrock carries it too
  };


  /// Where blocks have the water's load in the static stage: section "Water", parameter "Static
  /// place".
  enum class WaterPlace
  {
    moved, ///< where they have settled
    drawn  ///< where they were drawn: what slides does not leave the water's thrust
  };


  /// The tables of section "Water".
  struct WaterTables
  {
    std::string line_file;  ///< CSV x,y [m]; resolved path
    std::string level_file; ///< CSV time [s], level [m]; resolved path
    LinearTable line;       ///< phreatic line; empty: none
    LinearTable level;      ///< of the reservoir in time; empty: it stays

    bool empty() const
    {
      return line.empty() && level.empty();
    }
  };
} // namespace hybrid::scene
