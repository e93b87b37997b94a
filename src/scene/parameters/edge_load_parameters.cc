// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>

namespace hybrid::scene
{
  void declare(ParameterTable &table, EdgeLoadParameters &edge_loads)
  {
    ParameterSection section(table, {"Edge loads"});
    section.value(
      "Tractions",
      "'name: x min, x max, y min, y max, horizontal, vertical; ...' [m, Pa]",
      [&edge_loads](const std::string &text) {
        for (const auto &[name, row] : parse_rows(text, 6))
          edge_loads.tractions.push_back(
            {name, Vec2(row[0], row[2]), Vec2(row[1], row[3]), Vec2(row[4], row[5])});
      },
      "Tractions (to the right and up) on free edges of blocks with both ends in the box: dead loads "
      "per length of the initial edge that go with it and keep their direction. They act in the "
      "dynamic stage.");
    section.number("Start",
                   edge_loads.start,
                   "s",
                   ParameterRange::at_least(0.),
                   "Time at which the tractions begin to rise.");
    section.number("Rise time",
                   edge_loads.rise_time,
                   "s",
                   ParameterRange::at_least(0.),
                   "They rise linearly over this time, then stay; 0: at once.");
  }

  void check_edge_loads(const SceneParameters &scene, const ParameterTable &table)
  {
    if (!scene.edge_loads.tractions.empty() && !scene.blocks.enabled)
      throw table.error("Edge loads/Tractions",
                        "they act on blocks, and Model/Blocks = none has none");
    constexpr double largest = 1e12; // [Pa]: the modulus of diamond
    for (const EdgeTraction &load : scene.edge_loads.tractions)
      if (!(load.traction.cwiseAbs().maxCoeff() <= largest))
        throw table.error("Edge loads/Tractions",
                          "the traction of '" + load.name + "' must be at most " +
                            number_text(largest) + " [Pa]");
    for (const EdgeTraction &load : scene.edge_loads.tractions)
      if (!(load.lower.x() <= load.upper.x() && load.lower.y() <= load.upper.y()))
        throw table.error("Edge loads/Tractions",
                          "the box of '" + load.name +
                            "' is empty; it must be x min <= x max, y min <= y max");
  }
} // namespace hybrid::scene
