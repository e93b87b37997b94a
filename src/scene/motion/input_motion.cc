// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_source.h>
#include <hybrid/scene/motion/motion_words.h>
#include <hybrid/scene/motion/peak_scaling.h>

#include <algorithm>
#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// "1.75 m/s2 (0.1785 g)".
    std::string in_both_units(const double acceleration)
    {
      return in_words(acceleration) + " m/s2 (" + in_words(acceleration / 9.80665) + " g)";
    }


    /// How the motion follows from a record or spectrum with the peak @p found [m/s2].
    std::string
    scaling_of(const MotionSource &source, const MotionParameters &parameters, const double found)
    {
      if (source.own_peak.empty())
        return "";
      if (parameters.peak < 0. || found == 0.)
        return "peak " + in_both_units(found) + " " + source.own_peak + ", scale factor 1";
      return "peak " + in_both_units(parameters.peak) + ", scale factor " +
             in_words(parameters.peak / found) + " on " + in_both_units(found) + " " +
             source.own_peak;
    }


    /// "none, ricker or sine".
    std::string names_of(const std::vector<MotionSource> &sources)
    {
      std::string text;
      for (std::size_t i = 0; i < sources.size(); ++i)
        text += (i == 0 ? "" : i + 1 < sources.size() ? ", " : " or ") + sources[i].name;
      return text;
    }


    InputMotion make(const MotionParameters          &parameters,
                     const double                     time_step,
                     const std::vector<MotionSource> &sources)
    {
      const MotionSource *source = find_motion_source(parameters.type, sources);
      if (source == nullptr)
        throw InputError("Motion/Type is '" + parameters.type + "'; it must be " +
                         names_of(sources) + ".");
      InputMotion input;
      source->make(parameters, time_step, input);
      if (input.motion.empty())
        return input;

      const double found = input.motion.peak_acceleration();
      input.scaling      = scaling_of(*source, parameters, found);
      if (parameters.peak == 0.)
        input.motion = input.motion.scaled(0.);
      else if (parameters.peak > 0.)
        input.motion = scaled_to_peak(input.motion,
                                      parameters.peak,
                                      source->reads_record ? parameters.file : "Motion");
      if (parameters.peak >= 0.)
        for (std::vector<double> *series : {&input.fit.target, &input.fit.reached})
          for (double &value : *series)
            value *= parameters.peak / found;
      return input;
    }


    /// What happens when the motion or the run ends.
    void look_at_end(const MotionParameters &parameters, const double end_time, InputMotion &input)
    {
      const Motion &motion = input.motion;
      const double  T      = motion.duration();
      const double  end =
        parameters.start + (parameters.repetitions - 1) * parameters.repetition_interval + T;
      if (motion.peak_acceleration() == 0.)
        {
          if (!motion.empty())
            input.notes.push_back("Motion/Peak = 0: nothing shakes");
          return;
        }
      if (parameters.repetitions > 1 && parameters.repetition_interval < T * (1. - 1e-9))
        input.warnings.push_back("the motion lasts " + in_words(T) + " s and comes again every " +
                                 in_words(parameters.repetition_interval) +
                                 " s (Motion/Repetition interval): events overlap and add up, and "
                                 "what is said of its peaks is that of one");
      const double drift = motion.velocity(T);
      if (std::abs(drift) > 1e-3 * largest_velocity(motion) && input.warnings.empty())
        input.warnings.push_back("the motion ends with a velocity of " + in_words(drift) +
                                 " m/s, with which the base goes on; set Motion/Baseline "
                                 "correction = true to bring it to rest");
      if (end < end_time * (1. - 1e-9))
        input.notes.push_back("the motion ends at t = " + in_words(end) + " s, the run at " +
                              in_words(end_time) + " s: no acceleration comes in between");
      if (end <= end_time * (1. + 1e-9))
        return;
      const std::vector<double> &a = motion.samples();
      const auto larger = [](const double x, const double y) { return std::abs(x) < std::abs(y); };
      const double peak_time =
        parameters.start +
        motion.time_step() * (std::max_element(a.begin(), a.end(), larger) - a.begin());
      const std::string cut = "the run ends at t = " + in_words(end_time) + " s, the motion at " +
                              in_words(end) + " s: the rest of it is not used";
      if (peak_time > end_time)
        input.warnings.push_back(cut + ", with its peak at t = " + in_words(peak_time) + " s");
      else
        input.notes.push_back(cut);
    }
  } // namespace


  InputMotion make_input_motion(const MotionParameters          &parameters,
                                const TimeParameters            &time,
                                const std::vector<MotionSource> &sources)
  {
    InputMotion input = make(parameters, time.time_step, sources);
    look_at_end(parameters, time.end_time, input);
    return input;
  }


  InputMotion make_input_motion(const MotionParameters &parameters, const TimeParameters &time)
  {
    return make_input_motion(parameters, time, motion_sources());
  }


  Motion make_motion(const MotionParameters &parameters, const double time_step)
  {
    return make(parameters, time_step, motion_sources()).motion;
  }
} // namespace hybrid::scene
