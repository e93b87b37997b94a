// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/baseline.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_reader.h>
#include <hybrid/scene/motion/sine_burst.h>
#include <hybrid/scene/motion/synthetic_motion.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    std::string in_words(const double value)
    {
      std::ostringstream text;
      text.precision(4);
      text << value;
      return text.str();
    }


    double largest_velocity(const Motion &motion)
    {
      double largest = 0.;
      for (std::size_t i = 0; i < motion.samples().size(); ++i)
        largest = std::max(largest, std::abs(motion.velocity(i * motion.time_step())));
      return largest;
    }


    Motion make_ricker(const double frequency, const double time_step)
    {
      if (!(frequency > 0.))
        throw InputError("Motion/Frequency is " + in_words(frequency) +
                         "; a Ricker wavelet needs a positive one.");

      constexpr double most_samples = 1e6; // a second or two for the scene card
      const double     dt           = wave_spacing(frequency, time_step);
      if (!(3. / (frequency * dt) <= most_samples))
        throw InputError("Motion/Frequency is " + in_words(frequency) +
                         "; a Ricker wavelet in steps of " + in_words(dt) + " s has at least " +
                         in_words(3. / (most_samples * dt)) + " Hz.");
      const int half = static_cast<int>(std::ceil(1.5 / (frequency * dt) - 1e-9));

      std::vector<double> a(2 * half + 1);
      for (int i = 0; i <= 2 * half; ++i)
        {
          const double s = M_PI * frequency * (i - half) * dt;
          a[i]           = (1. - 2. * s * s) * std::exp(-s * s);
        }
      return Motion(dt, a);
    }


    Motion scaled_to_peak(const Motion &motion, const double peak, const std::string &source)
    {
      const double found = motion.peak_acceleration();
      if (!(found > 0.))
        throw InputError(source + ": the motion is zero and cannot be scaled to the peak of " +
                         in_words(peak) + " m/s2.");
      const Motion        scaled = motion.scaled(peak / found);
      std::vector<double> a      = scaled.samples();
      // the last bit of peak / found must not show in the peak
      for (std::size_t i = 0; i < a.size(); ++i)
        if (std::abs(a[i]) > peak || std::abs(motion.samples()[i]) == found)
          a[i] = std::copysign(peak, a[i]);
      return Motion(motion.time_step(), a);
    }


    void take_record(const MotionParameters &parameters, InputMotion &input)
    {
      const Motion raw       = parameters.type == "text"
                                 ? read_text_motion(parameters.file, parameters.file_unit)
                                 : read_at2_motion(parameters.file);
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


    void take_spectrum(const MotionParameters &parameters, InputMotion &input)
    {
      SpectrumMotion made   = make_spectrum_motion(parameters);
      input.motion          = std::move(made.motion);
      input.fit             = std::move(made.fit);
      const std::string fit = "the motion has the spectrum of " + parameters.spectrum_file +
                              " from " + in_words(input.fit.frequency.front()) + " to " +
                              in_words(input.fit.frequency.back()) + " Hz with a mean misfit of " +
                              in_words(100. * input.fit.mean_misfit()) + " %, at most " +
                              in_words(100. * input.fit.largest_misfit()) + " %";
      if (input.fit.mean_misfit() <= 0.05)
        input.notes.push_back(fit);
      else
        input.warnings.push_back(fit + "; try a longer Motion/Duration or another Motion/Seed");
    }


    /// "1.75 m/s2 (0.1785 g)".
    std::string in_both_units(const double acceleration)
    {
      return in_words(acceleration) + " m/s2 (" + in_words(acceleration / 9.80665) + " g)";
    }


    /// How the motion follows from a record or spectrum with the peak @p found [m/s2].
    std::string scaling_of(const MotionParameters &parameters, const double found)
    {
      if (parameters.type != "text" && parameters.type != "at2" && parameters.type != "spectrum")
        return "";
      const std::string source = parameters.type == "spectrum" ? "of the spectrum" : "as recorded";
      if (parameters.peak < 0. || found == 0.)
        return "peak " + in_both_units(found) + " " + source + ", scale factor 1";
      return "peak " + in_both_units(parameters.peak) + ", scale factor " +
             in_words(parameters.peak / found) + " on " + in_both_units(found) + " " + source;
    }


    InputMotion make(const MotionParameters &parameters, const double time_step)
    {
      InputMotion input;
      std::string source = "Motion";
      if (parameters.type == "none")
        return input;
      else if (parameters.type == "ricker")
        input.motion = make_ricker(parameters.frequency, time_step);
      else if (parameters.type == "sine")
        input.motion = scaled_to_peak(make_sine_burst(parameters, time_step), 1., source);
      else if (parameters.type == "synthetic")
        input.motion = make_synthetic_motion(parameters);
      else if (parameters.type == "spectrum")
        take_spectrum(parameters, input);
      else if (parameters.type == "text" || parameters.type == "at2")
        {
          source = parameters.file;
          take_record(parameters, input);
        }
      else
        throw InputError("Motion/Type is '" + parameters.type +
                         "'; it must be none, ricker, sine, synthetic, spectrum, text or at2.");

      const double found = input.motion.peak_acceleration();
      input.scaling      = scaling_of(parameters, found);
      if (parameters.peak == 0.)
        input.motion = input.motion.scaled(0.);
      else if (parameters.peak > 0.)
        input.motion = scaled_to_peak(input.motion, parameters.peak, source);
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
      const double  T = motion.duration(), end = parameters.start + T;
      if (motion.peak_acceleration() == 0.)
        return;
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


  InputMotion make_input_motion(const MotionParameters &parameters, const TimeParameters &time)
  {
    InputMotion input = make(parameters, time.time_step);
    look_at_end(parameters, time.end_time, input);
    return input;
  }


  Motion make_motion(const MotionParameters &parameters, const double time_step)
  {
    return make(parameters, time_step).motion;
  }
} // namespace hybrid::scene
