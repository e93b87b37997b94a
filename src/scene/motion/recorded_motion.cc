// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/baseline.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_reader.h>
#include <hybrid/scene/motion/motion_words.h>
#include <hybrid/scene/motion/recorded_motion.h>

#include <algorithm>
#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    double largest_displacement(const Motion &motion)
    {
      double largest = 0.;
      for (std::size_t i = 0; i < motion.samples().size(); ++i)
        largest = std::max(largest, std::abs(motion.displacement(i * motion.time_step())));
      return largest;
    }


    /// Somebody has corrected it, or it is a pulse: the cubic of the correction would bend it.
    bool ends_at_rest(const Motion &motion)
    {
      const double T = motion.duration();
      return std::abs(motion.velocity(T)) <= 1e-3 * largest_velocity(motion) &&
             std::abs(motion.displacement(T)) <= 1e-2 * largest_displacement(motion);
    }


    /// "the peak acceleration from ... to ... m/s2 and the peak velocity from ... to ... m/s"
    std::string both_peaks(const Motion &raw, const Motion &corrected)
    {
      return "the peak acceleration from " + in_words(raw.peak_acceleration()) + " to " +
             in_words(corrected.peak_acceleration()) + " m/s2 and the peak velocity from " +
             in_words(largest_velocity(raw)) + " to " + in_words(largest_velocity(corrected)) +
             " m/s";
    }


    /// "" if the correction hardly changes the peaks.
    std::string changed_peaks(const Motion &raw, const Motion &corrected)
    {
      constexpr double acceleration = 0.01, velocity = 0.05; // that count
      const double     a = raw.peak_acceleration(), b = corrected.peak_acceleration();
      const double     v = largest_velocity(raw), w = largest_velocity(corrected);
      if (std::abs(b - a) <= acceleration * a && std::abs(w - v) <= velocity * v)
        return "";
      return "the baseline correction changes " + both_peaks(raw, corrected) +
             "; a longer record, with rest at its end, changes less, and Motion/Baseline "
             "correction = false leaves it as it is";
    }


    /// Its offset is small beside the motion, and all that the correction changes of the peak.
    bool is_of_instrument(const Motion &raw, const Motion &corrected)
    {
      constexpr double small = 0.2, changed = 0.01; // of the peak
      const double     peak = raw.peak_acceleration();
      const double     mean = std::abs(raw.velocity(raw.duration())) / raw.duration();
      return mean <= small * peak &&
             std::abs(corrected.peak_acceleration() - peak) <= mean + changed * peak;
    }


    /// Take a record, without its offset if asked for, and tell of one.
    void take_record(const Motion &raw, const MotionParameters &parameters, InputMotion &input)
    {
      const Motion corrected = ends_at_rest(raw) ? raw : baseline_corrected(raw);
      input.motion           = parameters.baseline_correction ? corrected : raw;

      const double T = raw.duration(), drift = raw.velocity(T);
      if (std::abs(drift) <= 0.1 * largest_velocity(corrected))
        {
          const std::string changed = changed_peaks(raw, corrected);
          if (parameters.baseline_correction && !changed.empty())
            input.warnings.push_back(parameters.file + ": " + changed);
          return;
        }
      const std::string offset = parameters.file + " has an offset: its mean acceleration is " +
                                 in_words(drift / T) + " m/s2 (" +
                                 in_words(100. * std::abs(drift / T) / raw.peak_acceleration()) +
                                 " % of its peak), so that it ends with " + in_words(drift) +
                                 " m/s at " + in_words(raw.displacement(T)) + " m";
      if (!parameters.baseline_correction)
        {
          input.warnings.push_back(offset +
                                   "; set Motion/Baseline correction = true to take it out");
          return;
        }
      const bool is_small = is_of_instrument(raw, corrected);
      (is_small ? input.notes : input.warnings)
        .push_back(offset + (is_small ? "" : ", more than an instrument's") +
                   "; the baseline correction took it out and changed " +
                   both_peaks(raw, corrected) +
                   ". A pulse, or a record that stops within its motion, wants Motion/Baseline "
                   "correction = false");
    }


    void needs_a_file(const MotionParameters &motion, const ParameterTable &table)
    {
      if (motion.file.empty())
        throw table.error("Motion/File",
                          "Motion/Type = " + motion.type + " needs the file of a record");
    }
  } // namespace



  MotionSource text_source()
  {
    return {"text",
            [](const MotionParameters &parameters, double, InputMotion &input) {
              const Motion raw =
                read_text_motion(parameters.file, parameters.file_unit, &input.first_time);
              take_record(raw, parameters, input);
              if (std::abs(input.first_time) > raw.time_step())
                input.notes.push_back(parameters.file + " begins at " + in_words(input.first_time) +
                                      " s; here it begins with the run, or at Motion/Start");
            },
            needs_a_file,
            "as recorded",
            true};
  }



  MotionSource at2_source()
  {
    return {"at2",
            [](const MotionParameters &parameters, double, InputMotion &input) {
              take_record(read_at2_motion(parameters.file), parameters, input);
            },
            needs_a_file,
            "as recorded",
            true};
  }
} // namespace hybrid::scene
