// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/water_parameters.h>

#include <string>

namespace hybrid::scene
{
  /// What happens before the dynamic stage.
  enum class StaticStage
  {
    equilibrium, ///< blocks settle with their strengths active, and the run ends if they cannot
    move,        ///< the same, but what cannot stand starts from where it has got to
    held,        ///< blocks settle with unlimited friction and bonds, which become active at t = 0
    none         ///< the dynamic stage starts unloaded
  };

  /// Section "Water" and section "Gravity".
  struct EnvironmentParameters
  {
    double gravity    = 9.81; ///< downward acceleration [m/s2], >= 0
    double horizontal = 0.;   ///< pseudo-static coefficient k, of a lasting force k m g
                              ///< along +x [-]
    StaticStage static_stage    = StaticStage::equilibrium;
    bool        reset_softening = true; ///< slip at rest takes nothing of strengths
    std::string initial_stress =
      "elastic";                      ///< before the static stage, see resolve_initial_stress()
    int         lifts       = 10;     ///< of a mass that is placed in stages [-], 1..1000
    double      water_level = -1e300; ///< of the reservoir at the start [m]; none: below -1e299
    WaterTables water_tables;
    WaterMethod water_method        = WaterMethod::paper;
    bool        water_method_is_set = false; ///< by the user
    WaterPlace  static_water        = WaterPlace::moved;
    double      water_density       = 1000.; ///< [kg/m3], > 0

    bool has_level() const
    {
      return water_level > -1e299;
    }

    bool has_water() const
    {
      return has_level() || !water_tables.line.empty();
    }

    /// Elevation of the water at the start, the higher one of level and line [m]; below it the
    /// saturated materials hold (initial position of the block).
    double water_at(double x) const;

    /// The mass begins with the stress of being placed in lifts, one after another.
    bool is_staged() const
    {
      return initial_stress == "staged";
    }

    /// The section begins with stresses: Material::lateral_ratio() of the overburden's.
    bool has_initial_stress() const
    {
      return initial_stress != "elastic" && !is_staged();
    }
  };
} // namespace hybrid::scene
