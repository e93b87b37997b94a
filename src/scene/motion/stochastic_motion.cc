// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/baseline.h>
#include <hybrid/scene/motion/earthquake_source.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_words.h>
#include <hybrid/scene/motion/stochastic_motion.h>
#include <hybrid/scene/motion/synthetic_motion.h>
#include <hybrid/scene/random_numbers.h>

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>

namespace hybrid::scene
{
  namespace
  {
    constexpr double samples_per_period = 50.; // of the highest frequency
    constexpr double max_samples        = 1e6;
    constexpr double window_end         = 1.5; // of t_n; the window has fallen to 0.004


    double free_surface(const MotionParameters &parameters)
    {
      return parameters.outcrop ? 2. : 1.;
    }


    /// 1 in the band, 0 outside, cosine tapers over a quarter of an octave.
    double band(const MotionParameters &parameters, const double f)
    {
      const auto rise = [](const double octaves) {
        const double s = std::min(std::max(4. * octaves, 0.), 1.);
        return 0.5 * (1. - std::cos(M_PI * s));
      };
      if (!(f > 0.))
        return 0.;
      return rise(std::log2(f / parameters.lowest_frequency)) *
             rise(std::log2(parameters.highest_frequency / f));
    }


    /// When noise begins, how long it is, and all [s].
    struct Times
    {
      explicit Times(const MotionParameters &parameters)
        : lead(1. / parameters.lowest_frequency)
        , full(2. * shaking_duration(parameters.earthquake))
        , all(2. * lead + window_end * full)
        , spacing(1. / (samples_per_period * parameters.highest_frequency))
      {}

      double lead, full, all, spacing;
    };


    std::vector<double> windowed_noise(const MotionParameters &parameters, const std::size_t n)
    {
      const Times         times(parameters);
      RandomNumbers       random(static_cast<std::uint64_t>(parameters.seed));
      std::vector<double> noise(n, 0.);
      for (std::size_t i = 0; i < n; ++i)
        {
          const double s = (i * times.spacing - times.lead) / times.full;
          if (s > 0. && s < window_end)
            noise[i] = random.normal_pair().first * saragoni_hart_window(s);
        }
      return noise;
    }


    void say_what_it_is(const MotionParameters &parameters, InputMotion &input)
    {
      const EarthquakeSource &source = parameters.earthquake;
      input.notes.push_back(
        "magnitude " + in_words(source.magnitude) + " at " + in_words(1e-3 * source.distance) +
        " km: seismic moment " + in_words(seismic_moment(source)) + " N m, corner frequency " +
        in_words(corner_frequency(source)) + " Hz, shaking of " +
        in_words(shaking_duration(source)) + " s; " +
        in_words(100. * intensity_outside(parameters)) + " % of its Arias intensity are outside " +
        in_words(parameters.lowest_frequency) + " to " + in_words(parameters.highest_frequency) +
        " Hz");
    }


    void check_source(const MotionParameters &parameters, const ParameterTable &table)
    {
      check_frequency_band(parameters, table);
      const Times times(parameters);
      if (!(times.all / times.spacing <= max_samples))
        throw table.error("Motion/Highest frequency",
                          "makes a motion of more than a million samples: it lasts for " +
                            in_words(times.all) + " s");
    }
  } // namespace


  double saragoni_hart_window(const double s)
  {
    const double e = 0.2, n = 0.05;
    const double b = -e * std::log(n) / (1. + e * (std::log(e) - 1.)), c = b / e;
    return s <= 0. ? 0. : std::pow(std::exp(1.) / e * s, b) * std::exp(-c * s);
  }


  Motion make_stochastic_motion(const MotionParameters &parameters)
  {
    const Times       times(parameters);
    const std::size_t n     = static_cast<std::size_t>(std::ceil(times.all / times.spacing)) + 1;
    std::size_t       whole = 1; // with zeros behind: a transform is periodic
    while (whole < 2 * n)
      whole *= 2;

    Eigen::FFT<double>                transform;
    std::vector<std::complex<double>> spectrum;
    transform.fwd(spectrum, windowed_noise(parameters, whole));
    const double spacing = 1. / (whole * times.spacing);
    double       power = 0., count = 0.;
    for (std::size_t k = 1; k < whole / 2; ++k)
      if (band(parameters, k * spacing) > 0.)
        {
          power += std::norm(spectrum[k]);
          ++count;
        }
    const double to_unit = std::sqrt(count / power);
    for (std::size_t k = 0; k <= whole / 2; ++k)
      {
        const double f         = k * spacing;
        const double amplitude = band(parameters, f) / times.spacing; // of samples
        spectrum[k] *= amplitude == 0.
                         ? 0.
                         : amplitude * to_unit *
                             fourier_amplitude(parameters.earthquake, f, free_surface(parameters));
        if (k > 0 && k < whole / 2)
          spectrum[whole - k] = std::conj(spectrum[k]);
      }
    std::vector<double> a;
    transform.inv(a, spectrum);
    a.resize(n);
    const Motion motion(times.spacing, a);
    return parameters.baseline_correction ? baseline_corrected(motion, true) : motion;
  }


  double intensity_outside(const MotionParameters &parameters)
  {
    // Parseval: the intensity is the integral of the squared amplitude. Steps of a hundredth of an
    // octave over all frequencies that have any.
    const double ratio = std::exp2(0.01);
    double       all = 0., inside = 0.;
    for (double f = 1e-3; f < 1e3; f *= ratio)
      {
        const double amplitude = fourier_amplitude(parameters.earthquake, f, 1.);
        all += f * amplitude * amplitude;
        inside += f * std::pow(band(parameters, f) * amplitude, 2);
      }
    return 1. - inside / all;
  }


  MotionSource stochastic_source()
  {
    return {"stochastic",
            [](const MotionParameters &parameters, double, InputMotion &input) {
              input.motion = make_stochastic_motion(parameters);
              say_what_it_is(parameters, input);
            },
            check_source,
            "of the source"};
  }
} // namespace hybrid::scene
