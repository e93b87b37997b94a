// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hybrid::scene
{
  /// What the sides of the bedrock do: a value of Continuum/Sides. To add one: a file that returns
  /// it, and a line in side_boundaries().
  struct SideBoundary
  {
    std::string name;                    ///< of Continuum/Sides
    std::string words;                   ///< what the scene card calls it
    bool        holds_x         = false; ///< horizontal displacement zero
    bool        holds_y         = false; ///< vertical displacement zero
    double      normal_dashpots = 0.;    ///< impedance over rho c_p [-]
    double      shear_dashpots  = 0.;    ///< impedance over rho c_s [-]
    bool        has_free_field  = false; ///< dashpots and tractions are relative to a 1D column
                                         ///< that is solved beside the model

    bool has_dashpots() const
    {
      return normal_dashpots > 0. || shear_dashpots > 0.;
    }

    /// It prescribes a displacement.
    bool is_held() const
    {
      return holds_x || holds_y;
    }
  };


  /// All of them, in the order of the documentation.
  const std::vector<SideBoundary> &side_boundaries();
} // namespace hybrid::scene
