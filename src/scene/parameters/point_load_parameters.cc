// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>

namespace hybrid::scene
{
  void declare(ParameterTable &table, PointLoadParameters &point_loads)
  {
    ParameterSection section(table, {"Point loads"});
    section.value(
      "Forces",
      "'name: x, y, horizontal, vertical; ...' [m, N/m]",
      [&point_loads](const std::string &text) {
        for (const auto &row : parse_rows(text, 4))
          point_loads.loads.push_back(
            {row.first, Vec2(row.second[0], row.second[1]), Vec2(row.second[2], row.second[3])});
      },
      "Forces at points of the bedrock per metre of thickness (to the right and up), at the peak of a Ricker wavelet.");
    section.number("Frequency",
                   point_loads.frequency,
                   "Hz",
                   ParameterRange::above(0.),
                   "Dominant frequency f of the wavelet.");
    section.number("Start",
                   point_loads.start,
                   "s",
                   ParameterRange::at_least(0.),
                   "Time at which the wavelet starts; its peak is 1.5 / f later.");
  }

  void check_point_loads(const SceneParameters &scene, const ParameterTable &table)
  {
    if (!scene.point_loads.loads.empty() && !scene.has_continuum())
      throw table.error("Point loads/Forces",
                        "they act on the bedrock, and Model/Bedrock = rigid has none");
    constexpr double largest = 1e15; // [N/m]
    for (const PointLoad &load : scene.point_loads.loads)
      if (!(load.peak.cwiseAbs().maxCoeff() <= largest))
        throw table.error("Point loads/Forces",
                          "the force of '" + load.name + "' must be at most " +
                            number_text(largest) + " [N/m]");
  }
} // namespace hybrid::scene
