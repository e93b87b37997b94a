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


    /// The vertical component, and what is to be said of it. @param factor of the other one [-].
    void add_vertical(const MotionSource     &source,
                      const MotionParameters &parameters,
                      const double            factor,
                      const double            time_step,
                      InputMotion            &input)
    {
      MotionParameters of_vertical = parameters;
      of_vertical.file             = parameters.vertical_file;
      InputMotion read;
      source.make(of_vertical, time_step, read);
      if (std::abs(read.first_time - input.first_time) >
          0.5 * std::min(read.motion.time_step(), input.motion.time_step()))
        throw InputError(of_vertical.file,
                         0,
                         "its times begin at " + in_words(read.first_time) + " s and those of " +
                           parameters.file + " at " + in_words(input.first_time) +
                           " s; both components must begin at the same time.");
      const double found = read.motion.peak_acceleration();
      input.vertical     = parameters.vertical_peak > 0.
                             ? scaled_to_peak(read.motion, parameters.vertical_peak, of_vertical.file)
                             : read.motion.scaled(parameters.vertical_peak == 0. ? 0. : factor);
      const double peak  = input.vertical.peak_acceleration();
      input.notes.push_back("vertical component: peak " + in_both_units(peak) + ", scale factor " +
                            in_words(found > 0. ? peak / found : factor) + " on " +
                            in_both_units(found) + " as recorded, " +
                            in_words(input.vertical.duration()) + " s");
      input.notes.insert(input.notes.end(), read.notes.begin(), read.notes.end());
      input.warnings.insert(input.warnings.end(), read.warnings.begin(), read.warnings.end());
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
      if (!parameters.vertical_file.empty())
        add_vertical(*source,
                     parameters,
                     parameters.peak >= 0. && found > 0. ? parameters.peak / found : 1.,
                     time_step,
                     input);
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
      const double  T      = std::max(motion.duration(), input.vertical.duration());
      const double  end =
        parameters.start + (parameters.repetitions - 1) * parameters.repetition_interval + T;
      if (motion.peak_acceleration() == 0. && input.vertical.peak_acceleration() == 0.)
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
      const Motion *const components[] = {&motion, &input.vertical};
      for (const Motion *component : components)
        if (const double drift = component->velocity(T);
            std::abs(drift) > 1e-3 * largest_velocity(*component) && input.warnings.empty())
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
