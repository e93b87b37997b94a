// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/baseline.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/synthetic_motion.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/scene/random_numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    /// Kanai-Tajimi power spectrum over that of the white noise [-]; r = f / ground frequency.
    double kanai_tajimi(const double r)
    {
      const double damping = 0.6; // of the ground filter [-]
      const double b       = 4. * damping * damping * r * r;
      return (1. + b) / ((1. - r * r) * (1. - r * r) + b);
    }


    /// What the second filter of Clough and Penzien leaves of it [-].
    double second_filter(const double r)
    {
      const double damping = 0.6, corner = 0.1; // of the ground frequency
      const double q = r / corner, q2 = q * q;
      return q2 * q2 / ((1. - q2) * (1. - q2) + 4. * damping * damping * q2);
    }


    void check(const MotionParameters &parameters)
    {
      const auto refuse =
        [](const std::string &name, const double value, const std::string &allowed) {
          std::ostringstream sentence;
          sentence << "Motion/" << name << " is " << value << "; a synthetic motion needs "
                   << allowed << ".";
          throw InputError(sentence.str());
        };
      if (!(parameters.frequency > 0.))
        refuse("Frequency", parameters.frequency, "a positive one");
      if (!(parameters.lowest_frequency >= 0.))
        refuse("Lowest frequency", parameters.lowest_frequency, "at least 0");
      if (!(parameters.highest_frequency > parameters.lowest_frequency))
        refuse("Highest frequency", parameters.highest_frequency, "more than the lowest frequency");
      if (!(parameters.duration * parameters.highest_frequency >= 1.))
        refuse("Duration", parameters.duration, "at least one period of the highest frequency");
      if (!(parameters.duration * parameters.highest_frequency <= 5000.))
        refuse("Duration", parameters.duration, "at most 5000 periods of the highest frequency");
    }
  } // namespace


  double earthquake_envelope(const double s)
  {
    const double rise = 0.15, fall = 0.6;
    if (s < rise)
      return (s / rise) * (s / rise);
    if (s <= fall)
      return 1.;
    const double c = std::cos(0.5 * M_PI * (s - fall) / (1. - fall));
    return c * c;
  }


  Motion make_synthetic_motion(const MotionParameters &parameters)
  {
    check(parameters);
    const double      T = parameters.duration;
    const std::size_t n =
      static_cast<std::size_t>(std::ceil(T * 50. * parameters.highest_frequency)) + 1;
    const double dt = T / (n - 1);

    // harmonics at half the spacing 1/T, so that the noise does not repeat within the duration
    const double      df = 0.5 / T;
    const std::size_t harmonics =
      std::max(1., std::floor((parameters.highest_frequency - parameters.lowest_frequency) / df));
    std::vector<double> a(n, 0.);
    RandomNumbers       random(static_cast<std::uint64_t>(parameters.seed));
    for (std::size_t k = 0; k < harmonics; ++k)
      {
        const double f = parameters.lowest_frequency + (k + 0.5) * df;
        const double r = f / parameters.frequency;
        const double amplitude =
          std::sqrt(kanai_tajimi(r) * (parameters.clough_penzien ? second_filter(r) : 1.));
        const auto [c, s] = random.normal_pair();
        for (std::size_t i = 0; i < n; ++i)
          {
            const double phase = 2. * M_PI * f * (i * dt);
            a[i] += amplitude * (c * std::cos(phase) + s * std::sin(phase));
          }
      }
    for (std::size_t i = 0; i < n; ++i)
      a[i] *= earthquake_envelope(double(i) / (n - 1));

    Motion motion(dt, a);
    if (parameters.baseline_correction)
      motion = baseline_corrected(motion, true);
    return motion.scaled(1. / motion.peak_acceleration());
  }



  void check_frequency_band(const MotionParameters &motion, const ParameterTable &table)
  {
    if (motion.lowest_frequency >= motion.highest_frequency)
      throw table.error("Motion/Lowest frequency",
                        "must be below Motion/Highest frequency = " +
                          number_text(motion.highest_frequency) + " [Hz]");
  }



  MotionSource synthetic_source()
  {
    return {"synthetic",
            [](const MotionParameters &parameters, double, InputMotion &input) {
              input.motion = make_synthetic_motion(parameters);
            },
            check_frequency_band};
  }
} // namespace hybrid::scene
