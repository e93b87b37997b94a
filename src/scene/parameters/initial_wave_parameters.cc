// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>

namespace hybrid::scene
{
  namespace
  {
    Vec2 parse_point(const std::string &text)
    {
      const std::vector<std::string> parts = split(text, ',');
      if (parts.size() == 2)
        if (const auto x = parse_number(parts[0]), y = parse_number(parts[1]); x && y)
          return {*x, *y};
      throw InputError("must be two numbers, x, y");
    }
  } // namespace



  void declare(ParameterTable &table, InitialWaveParameters &wave)
  {
    ParameterSection section(table, {"Initial wave"});
    section.choice<WaveType>(
      "Type",
      wave.type,
      {{"none", WaveType::none}, {"P", WaveType::pressure}, {"SV", WaveType::shear}},
      "A packet of plane waves with a Gaussian envelope that is in the bedrock at t = 0, with the "
      "wave speed of the rock at its centre.");
    section.number("Direction",
                   wave.direction,
                   "deg",
                   ParameterRange::closed(-360., 360.),
                   "Where it travels, from +x: 0 to the right, 90 up, -90 down.");
    section.value(
      "Centre",
      "'x, y' [m]",
      [&wave](const std::string &text) {
        if (!trim(text).empty())
          wave.centre = parse_point(text);
      },
      "Middle of the packet at t = 0; empty: 0, 0.");
    section.number(
      "Amplitude",
      wave.amplitude,
      "m",
      ParameterRange::closed(-1e3, 1e3),
      "Displacement at the centre at t = 0: of P waves forwards, of SV waves to the left "
      "as seen on the way.");
    section.number("Frequency",
                   wave.frequency,
                   "Hz",
                   ParameterRange::closed(1e-6, 1e6),
                   "Of the wave in the packet.");
    section.number("Length",
                   wave.length,
                   "wave lengths",
                   ParameterRange::closed(0.25, 1e6),
                   "Standard deviation of the envelope along the way.");
    section.number(
      "Width",
      wave.width,
      "wave lengths",
      ParameterRange::closed(0., 1e6),
      "Standard deviation across the way, at least 0.5; 0: a plane front without end.");
  }



  void check_initial_wave(const SceneParameters &scene, const ParameterTable &table)
  {
    const InitialWaveParameters &wave = scene.initial_wave;
    if (wave.type == WaveType::none)
      return;
    if (!scene.has_continuum())
      throw table.error("Initial wave/Type",
                        "it travels in the continuum: Model/Bedrock = continuum is needed");
    if (wave.width != 0. && wave.width < 0.5)
      throw table.error(
        "Initial wave/Width",
        "a beam narrower than 0.5 wave lengths does not travel one way; 0 stands for "
        "a plane front");
  }
} // namespace hybrid::scene
