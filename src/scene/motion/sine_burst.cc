// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/baseline.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/peak_scaling.h>
#include <hybrid/scene/motion/sine_burst.h>
#include <hybrid/scene/parameters/parameter_values.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hybrid::scene
{
  double wave_spacing(const double frequency, const double time_step)
  {
    return time_step / std::max(1., std::ceil(400. * frequency * time_step - 1e-9));
  }


  Motion make_sine_burst(const MotionParameters &parameters, const double time_step)
  {
    constexpr double usual = 2.;
    const double     f = parameters.frequency, cycles = parameters.cycles;
    const double     taper =
      std::isnan(parameters.taper) ? std::min(usual, 0.5 * cycles) : parameters.taper;
    if (2. * taper > cycles)
      {
        std::ostringstream sentence;
        sentence << "Motion/Taper is " << taper
                 << "; it must be at most half of Motion/Cycles = " << cycles << ".";
        throw InputError(sentence.str());
      }

    const double dt = wave_spacing(f, time_step);
    if (!(cycles / f / dt <= 1e7))
      {
        std::ostringstream sentence;
        sentence << "Motion/Cycles is " << cycles << "; a sine burst of " << f << " Hz has at most "
                 << 1e7 * f * dt << ".";
        throw InputError(sentence.str());
      }
    std::vector<double> a;
    for (int i = 0; i * dt <= cycles / f * (1. + 1e-12); ++i)
      {
        const double cycle = f * (i * dt), to_end = std::min(cycle, cycles - cycle);
        const double rise =
          to_end < taper ? std::sin(0.5 * M_PI * std::max(0., to_end) / taper) : 1.;
        a.push_back(rise * rise * std::sin(2. * M_PI * cycle));
      }
    const Motion motion(dt, a);
    return parameters.baseline_correction ? baseline_corrected(motion, true) : motion;
  }



  MotionSource sine_source()
  {
    return {"sine",
            [](const MotionParameters &parameters, const double time_step, InputMotion &input) {
              input.motion = scaled_to_peak(make_sine_burst(parameters, time_step), 1., "Motion");
            },
            [](const MotionParameters &motion, const ParameterTable &table) {
              if (2. * motion.taper > motion.cycles)
                throw table.error("Motion/Taper",
                                  "must be at most half of Motion/Cycles = " +
                                    number_text(motion.cycles));
            }};
  }
} // namespace hybrid::scene
