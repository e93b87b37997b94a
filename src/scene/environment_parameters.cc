// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameter_declarations.h>

namespace hybrid::scene
{
  void declare(ParameterTable &table, EnvironmentParameters &environment)
  {
    ParameterSection gravity(table, {"Gravity"});
    gravity.number("Acceleration",
                   environment.gravity,
                   "m/s2",
                   ParameterRange::at_least(0.),
                   "Downward acceleration; 0 switches gravity off.");
    gravity.choice<StaticStage>(
      "Static stage",
      environment.static_stage,
      {{"equilibrium", StaticStage::equilibrium},
       {"held", StaticStage::held},
       {"none", StaticStage::none}},
      "Before the dynamic stage: equilibrium lets the blocks settle with their strengths active, "
      "held with unlimited friction and bonds (for masses that cannot stand), none starts "
      "unloaded.");
    ParameterSection water(table, {"Water"});
    water.number_or(
      "Level",
      {"none", environment.water_level},
      "m",
      ParameterRange::any(),
      "Elevation of the water; blocks and belt that start below it have their saturated "
      "materials.");
  }
} // namespace hybrid::scene
