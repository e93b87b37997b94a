// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/motion_source.h>
#include <hybrid/scene/parameters/parameter_declarations.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    std::vector<std::pair<std::string, std::string>> types()
    {
      std::vector<std::pair<std::string, std::string>> names;
      for (const MotionSource &source : motion_sources())
        names.push_back({source.name, source.name});
      return names;
    }


    /// In m/s2.
    const std::vector<std::pair<std::string, double>> acceleration_units = {{"m/s2", 1.},
                                                                            {"g", 9.80665},
                                                                            {"cm/s2", 0.01},
                                                                            {"gal", 0.01}};


    void declare_source(ParameterSection &section, MotionParameters &motion)
    {
      section.choice<std::string>(
        "Type",
        motion.type,
        types(),
        "Source of the motion: a Ricker wavelet, a sine burst, a synthetic accelerogram, one that "
        "has a given response spectrum, one of an earthquake of given magnitude and distance "
        "(stochastic), a text file of two columns (time [s], acceleration [Unit]), or a PEER .at2 "
        "file.");
      section.file("File", motion.file, "a text or .at2 file", "The record.");
      section.choice<double>(
        "Unit",
        motion.file_unit,
        acceleration_units,
        "Unit of the accelerations in a text or spectrum file (.at2 files are in "
        "g, unless their header says otherwise).");
      section.quantity_or(
        "Peak",
        {"as recorded", motion.peak},
        motion.peak_has_unit,
        acceleration_units,
        ParameterRange::closed(0., 1e4),
        "Scale the motion to this peak acceleration; as recorded: leave a record as it is "
        "and a spectrum or an earthquake as given; ricker, sine and synthetic have 1 m/s2.");
      section.file("Vertical file",
                   motion.vertical_file,
                   "a text or .at2 file",
                   "Record of the vertical component (along +y), which shakes beside that of File: "
                   "of the same Type, Unit and Meaning. Empty: none.");
      section.quantity_or(
        "Vertical peak",
        {"as File", motion.vertical_peak},
        motion.vertical_peak_has_unit,
        acceleration_units,
        ParameterRange::closed(0., 1e4),
        "Scale the vertical component to this peak acceleration; as File: by the factor of File.");
    }

    void declare_synthesis(ParameterSection &section, MotionParameters &motion)
    {
      const ParameterRange positive = ParameterRange::above(0.);
      section.number(
        "Frequency",
        motion.frequency,
        "Hz",
        ParameterRange::closed(1e-6, 1e6),
        "Dominant frequency of the Ricker wavelet, that of the sine burst, predominant one of the "
        "synthetic motion.");
      section.number("Cycles", motion.cycles, "", positive, "Number of cycles of the sine burst.");
      section.number_or(
        "Taper",
        {"automatic", motion.taper},
        "",
        ParameterRange::at_least(0.),
        "Cycles over which the sine burst rises to its peak, and falls at the end; at "
        "most half of Cycles; automatic: 2, or half of Cycles where that is less.");
      section.number(
        "Lowest frequency",
        motion.lowest_frequency,
        "Hz",
        positive,
        "Lowest frequency of a synthetic or stochastic motion or of the spectrum to be "
        "met.");
      section.number("Highest frequency",
                     motion.highest_frequency,
                     "Hz",
                     positive,
                     "Highest frequency of a synthetic or stochastic motion or of the spectrum to "
                     "be met.");
      section.number(
        "Duration", motion.duration, "s", positive, "Duration of a synthetic or spectrum motion.");
      section.integer("Seed",
                      motion.seed,
                      {0, 2147483647},
                      "Seed of a synthetic, stochastic or spectrum motion.");
      section.choice<bool>(
        "Noise spectrum",
        motion.clough_penzien,
        {{"Kanai-Tajimi", false}, {"Clough-Penzien", true}},
        "Power spectrum of a synthetic motion: Kanai-Tajimi passes long periods in full; "
        "Clough-Penzien has a second filter, at a tenth of Frequency, which takes them out.");
    }

    void declare_earthquake(ParameterSection &section, EarthquakeSource &source)
    {
      const ParameterRange positive = ParameterRange::above(0.);
      section.number("Magnitude",
                     source.magnitude,
                     "",
                     ParameterRange::closed(-2., 9.5),
                     "Moment magnitude of a stochastic motion.");
      section.number("Distance",
                     source.distance,
                     "m",
                     ParameterRange::closed(100., 1e6),
                     "From the source of a stochastic motion to the site; waves spread as 1/R, "
                     "which holds to some 70 km.");
      section.number("Stress drop",
                     source.stress_drop,
                     "Pa",
                     positive,
                     "Of the source of a stochastic motion: with the magnitude it sets the corner "
                     "frequency.");
      section.number("Source velocity",
                     source.velocity,
                     "m/s",
                     positive,
                     "Of S waves at the source of a stochastic motion.");
      section.number("Source density",
                     source.density,
                     "kg/m3",
                     positive,
                     "At the source of a stochastic motion.");
      section.number("Quality factor",
                     source.quality,
                     "",
                     positive,
                     "Q at 1 Hz on the way from the source to the site: exp(-pi f R / (Q v)).");
      section.number("Quality exponent",
                     source.quality_exponent,
                     "",
                     ParameterRange::closed(0., 1.5),
                     "Q grows with frequency to this power.");
      section.number("Kappa",
                     source.kappa,
                     "s",
                     ParameterRange::at_least(0.),
                     "Attenuation of a stochastic motion near the site: exp(-pi kappa f).");
    }

    void declare_spectrum(ParameterSection &section, MotionParameters &motion)
    {
      section.file("Spectrum file",
                   motion.spectrum_file,
                   "a text file of two columns",
                   "Response spectrum that Type = spectrum meets: period or frequency, and "
                   "pseudo-acceleration [Unit].");
      section.choice<bool>("Spectrum column",
                           motion.spectrum_by_frequency,
                           {{"period", false}, {"frequency", true}},
                           "First column of the spectrum file: period [s] or frequency [Hz].");
      section.number("Spectrum damping",
                     motion.spectrum_damping,
                     "",
                     ParameterRange::open(0., 1.),
                     "Damping ratio of the oscillators that the spectrum is for.");
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
      "wave itself. A rigid base moves as the outcrop, so by twice the upgoing wave.");
    section.number("Angle",
                   motion.angle,
                   "deg",
                   ParameterRange::closed(-360., 360.),
                   "Direction of shaking from +x: 0 is horizontal (S wave), 90 vertical (P wave).");
    section.number(
      "Start", motion.start, "s", ParameterRange::at_least(0.), "Time at which the motion starts.");
    section.integer(
      "Repetitions",
      motion.repetitions,
      {1, 1000},
      "How often the motion comes, for what the first event leaves and what each further one "
      "adds; hybrid condition does this until little is added.");
    section.number("Repetition interval",
                   motion.repetition_interval,
                   "s",
                   ParameterRange::above(0.),
                   "From the start of one event to that of the next.");
    declare_synthesis(section, motion);
    declare_earthquake(section, motion.earthquake);
    declare_spectrum(section, motion);
    section.toggle("Baseline correction",
                   motion.baseline_correction,
                   "Make velocity and displacement end at zero (all types; a ricker does anyway).");
  }

  void check_vertical(const MotionParameters &motion, const ParameterTable &table)
  {
    if (motion.vertical_file.empty())
      {
        if (motion.vertical_peak >= 0.)
          throw table.error("Motion/Vertical peak", "is not used without Motion/Vertical file");
        return;
      }
    const MotionSource *source = find_motion_source(motion.type, motion_sources());
    if (source == nullptr || !source->reads_record)
      throw table.error("Motion/Vertical file",
                        "is not used unless Motion/Type is set to text or at2");
    if (std::abs(std::cos(motion.angle * M_PI / 180.)) < 1e-6)
      throw table.error("Motion/Vertical file",
                        "is a second component, but with Motion/Angle = " +
                          number_text(motion.angle) + " that of Motion/File is vertical, too");
  }

  void check(const MotionParameters &motion, const ParameterTable &table)
  {
    if (motion.type == "none" && table.is_set("Motion/Type"))
      return; // switched off: the rest of the section waits for the motion to come back
    check_vertical(motion, table);
    if (!motion.file.empty() && !table.is_set("Motion/Type"))
      throw table.error("Motion/File", "is not used unless Motion/Type is set to text or at2");
    if (!motion.spectrum_file.empty() && motion.type != "spectrum")
      throw table.error("Motion/Spectrum file",
                        "is not used unless Motion/Type is set to spectrum");
    const MotionSource *source = find_motion_source(motion.type, motion_sources());
    if (source != nullptr && source->check != nullptr)
      source->check(motion, table);
  }
} // namespace hybrid::scene
