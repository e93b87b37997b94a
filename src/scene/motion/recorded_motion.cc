// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/baseline.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_reader.h>
#include <hybrid/scene/motion/motion_words.h>
#include <hybrid/scene/motion/recorded_motion.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// Take a record, without its offset if asked for, and tell of one.
    void take_record(const Motion &raw, const MotionParameters &parameters, InputMotion &input)
    {
      const Motion corrected = baseline_corrected(raw);
      input.motion           = parameters.baseline_correction ? corrected : raw;

      const double T = raw.duration(), drift = raw.velocity(T);
      if (std::abs(drift) <= 0.1 * largest_velocity(corrected))
        return;
      const std::string offset = parameters.file + " has an offset: its mean acceleration is " +
                                 in_words(drift / T) + " m/s2 (" +
                                 in_words(100. * std::abs(drift / T) / raw.peak_acceleration()) +
                                 " % of its peak), so that it ends with " + in_words(drift) +
                                 " m/s at " + in_words(raw.displacement(T)) + " m";
      if (parameters.baseline_correction)
        input.notes.push_back(offset + "; the baseline correction took it out");
      else
        input.warnings.push_back(offset + "; set Motion/Baseline correction = true to take it out");
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
              take_record(read_text_motion(parameters.file, parameters.file_unit),
                          parameters,
                          input);
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
