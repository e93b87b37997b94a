// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameter_declarations.h>

namespace hybrid::scene
{
  namespace
  {
    void declare_source(ParameterSection &section, MotionParameters &motion)
    {
      section.choice<std::string>(
        "Type",
        motion.type,
        {{"none", "none"},
         {"ricker", "ricker"},
         {"synthetic", "synthetic"},
         {"text", "text"},
         {"at2", "at2"}},
        "Source of the motion: a Ricker wavelet, a synthetic accelerogram, a text file "
        "of two columns (time [s], acceleration [Unit]), or a PEER .at2 file.");
      section.file("File", motion.file, "a text or .at2 file", "The record.");
      section.choice<double>("Unit",
                             motion.file_unit,
                             {{"m/s2", 1.}, {"g", 9.80665}, {"cm/s2", 0.01}},
                             "Unit of the accelerations in a text file (.at2 files are in g).");
      section.number_or(
        "Peak",
        {"as recorded", motion.peak},
        "m/s2",
        ParameterRange::at_least(0.),
        "Scale the motion to this peak acceleration; as recorded: leave a record as it is, "
        "give ricker and synthetic 1 m/s2.");
    }

    void declare_synthesis(ParameterSection &section, MotionParameters &motion)
    {
      const ParameterRange positive = ParameterRange::above(0.);
      section.number(
        "Frequency",
        motion.frequency,
        "Hz",
        positive,
        "Dominant frequency of the Ricker wavelet, predominant one of the synthetic motion.");
      section.number("Lowest frequency",
                     motion.lowest_frequency,
                     "Hz",
                     positive,
                     "High-pass corner of the synthetic motion.");
      section.number("Highest frequency",
                     motion.highest_frequency,
                     "Hz",
                     positive,
                     "Low-pass corner of the synthetic motion.");
      section.number(
        "Duration", motion.duration, "s", positive, "Duration of the synthetic motion.");
      section.integer("Seed", motion.seed, {0, 2147483647}, "Seed of the synthetic motion.");
    }
  } // namespace

  void declare(ParameterTable &table, MotionParameters &motion)
  {
    ParameterSection section(table, {"Motion"});
    declare_source(section, motion);
    section.choice<bool>(
      "Meaning",
      motion.outcrop,
      {{"outcrop", true}, {"incident", false}},
      "What the motion is: that of a rock outcrop (twice the upgoing wave) or the upgoing "
      "wave itself.");
    section.number("Angle",
                   motion.angle,
                   "deg",
                   ParameterRange::closed(-360., 360.),
                   "Direction of shaking from +x: 0 is horizontal (S wave), 90 vertical (P wave).");
    section.number(
      "Start", motion.start, "s", ParameterRange::at_least(0.), "Time at which the motion starts.");
    declare_synthesis(section, motion);
    section.toggle("Baseline correction",
                   motion.baseline_correction,
                   "Make velocity and displacement end at zero (text, at2 and synthetic).");
  }

  void check(const MotionParameters &motion, const ParameterTable &table)
  {
    if ((motion.type == "text" || motion.type == "at2") && motion.file.empty())
      throw table.error("Motion/File",
                        "Motion/Type = " + motion.type + " needs the file of a record");
    if (!motion.file.empty() && !table.is_set("Motion/Type"))
      throw table.error("Motion/File", "is not used unless Motion/Type is set to text or at2");
    if (motion.type == "synthetic" && motion.lowest_frequency >= motion.highest_frequency)
      throw table.error("Motion/Lowest frequency",
                        "must be below Motion/Highest frequency = " +
                          number_text(motion.highest_frequency) + " [Hz]");
  }
} // namespace hybrid::scene
