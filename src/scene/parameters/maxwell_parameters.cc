// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>

#include <sstream>

namespace hybrid::scene
{
  void declare(ParameterTable &table, MaxwellParameters &maxwell)
  {
    ParameterSection section(table, {"Maxwell damping"});
    section.number("Bedrock ratio",
                   maxwell.bedrock_ratio,
                   "",
                   ParameterRange::closed(0., 0.25),
                   "Damping of the bedrock that does not depend on frequency, as a fraction of "
                   "critical: 1/(2 Q); 0: off. It adds to Rayleigh damping.");
    section.number("Block ratio",
                   maxwell.block_ratio,
                   "",
                   ParameterRange::closed(0., 0.25),
                   "The same of the sliding mass; 0: off. It adds to Blocks/Damping ratio.");
    section.number("Lowest frequency",
                   maxwell.lowest,
                   "Hz",
                   ParameterRange::above(0.),
                   "Frequency from which the ratios hold.");
    section.number("Highest frequency",
                   maxwell.highest,
                   "Hz",
                   ParameterRange::above(0.),
                   "Frequency up to which the ratios hold. Waves of the geometric middle of both "
                   "have the material's speed.");
    section.integer("Branches",
                    maxwell.branches,
                    {1, 8},
                    "Maxwell branches beside the spring; three hold a ratio over a decade within "
                    "1 %.");
  }

  void check_maxwell(const SceneParameters &scene, const ParameterTable &table)
  {
    const MaxwellParameters &maxwell = scene.maxwell;
    if (!(maxwell.highest > maxwell.lowest))
      {
        std::ostringstream text;
        text << "must be above Maxwell damping/Lowest frequency = " << maxwell.lowest << " Hz";
        throw table.error("Maxwell damping/Highest frequency", text.str());
      }
    if (maxwell.bedrock_ratio > 0. && scene.initial_wave.type != WaveType::none)
      throw table.error("Maxwell damping/Bedrock ratio",
                        "must be 0 with an initial wave, whose past is not known");
  }
} // namespace hybrid::scene
