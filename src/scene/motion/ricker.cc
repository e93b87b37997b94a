// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_words.h>
#include <hybrid/scene/motion/ricker.h>
#include <hybrid/scene/motion/sine_burst.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    Motion make_ricker(const double frequency, const double time_step)
    {
      if (!(frequency > 0.))
        throw InputError("Motion/Frequency is " + in_words(frequency) +
                         "; a Ricker wavelet needs a positive one.");

      constexpr double max_samples = 1e6; // a second or two for the scene card
      const double     widest      = wave_spacing(frequency, time_step);
      if (!(3. / (frequency * widest) <= max_samples))
        throw InputError("Motion/Frequency is " + in_words(frequency) +
                         "; a Ricker wavelet in steps of " + in_words(widest) + " s has at least " +
                         in_words(3. / (max_samples * widest)) + " Hz.");
      // The peak comes at 1.5 / frequency with any time step.
      const int    half = static_cast<int>(std::ceil(1.5 / (frequency * widest) - 1e-9));
      const double dt   = 1.5 / (frequency * half);

      std::vector<double> a(2 * half + 1);
      for (int i = 0; i <= 2 * half; ++i)
        {
          const double s = M_PI * frequency * (i - half) * dt;
          a[i]           = (1. - 2. * s * s) * std::exp(-s * s);
        }
      return Motion(dt, a);
    }
  } // namespace



  MotionSource ricker_source()
  {
    return {"ricker",
            [](const MotionParameters &parameters, const double time_step, InputMotion &input) {
              input.motion = make_ricker(parameters.frequency, time_step);
            }};
  }
} // namespace hybrid::scene
