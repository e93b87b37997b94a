// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/baseline.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_words.h>
#include <hybrid/scene/motion/spectrum_motion.h>
#include <hybrid/scene/motion/synthetic_motion.h>
#include <hybrid/scene/random_numbers.h>

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    constexpr double samples_per_period = 30.; // of the highest frequency
    constexpr int    iterations         = 60;
    constexpr int    sets_of_phases     = 8; // tried until one is good
    constexpr double good_misfit        = 0.05;
    constexpr int    control_points     = 100;
    constexpr double max_samples        = 3e5; // a quarter of a minute


    /// Motion from amplitudes and phases at multiples of 1/(2T), so that it does not repeat in T.
    class Synthesis
    {
    public:
      Synthesis(const MotionParameters &parameters, const double highest)
        : correct(parameters.baseline_correction)
        , duration(parameters.duration)
        , half(static_cast<std::size_t>(std::ceil(samples_per_period * highest * duration)))
        , spectrum(2 * half, 0.)
      {}

      double frequency(const std::size_t k) const
      {
        return k * spacing();
      }

      double spacing() const
      {
        return 0.5 / duration;
      }

      Motion make(const std::vector<double> &amplitude, const std::vector<double> &phase)
      {
        std::fill(spectrum.begin(), spectrum.end(), 0.);
        for (std::size_t k = 1; k < amplitude.size(); ++k)
          spectrum[k] = std::polar(amplitude[k] * half, phase[k]);
        for (std::size_t k = 1; k < amplitude.size(); ++k)
          spectrum[2 * half - k] = std::conj(spectrum[k]);
        std::vector<std::complex<double>> series;
        transform.inv(series, spectrum);
        std::vector<double> a(half + 1);
        for (std::size_t i = 0; i <= half; ++i)
          a[i] = series[i % (2 * half)].real() * earthquake_envelope(double(i) / half);
        const Motion motion(duration / half, a);
        return correct ? baseline_corrected(motion, true) : motion;
      }

    private:
      const bool                        correct;
      const double                      duration; ///< [s]
      const std::size_t                 half;     ///< samples in the duration
      std::vector<std::complex<double>> spectrum;
      Eigen::FFT<double>                transform;
    };


    /**
     * Power spectral density [m2/s3] over w that has the response spectrum on average
     * (Gasparini & Vanmarcke 1976):
     *   G(w) = (S_a^2 / r^2 - int_0^w G dw) / (w (pi/(4 z_s) - 1)), z_s = z / (1 - exp(-2 z w T)),
     * with the peak factor r = 3. Only the start of the iteration.
     */
    std::vector<double> starting_amplitudes(const ResponseSpectrum &target,
                                            const MotionParameters &parameters,
                                            const Synthesis        &synthesis,
                                            const std::size_t       first,
                                            const std::size_t       last)
    {
      std::vector<double> amplitude(last + 1, 0.);
      const double        dw    = 2. * M_PI * synthesis.spacing();
      double              below = 0.; // integral so far
      for (std::size_t k = first; k <= last; ++k)
        {
          const double f = synthesis.frequency(k), w = 2. * M_PI * f,
                       z       = parameters.spectrum_damping;
          const double zs      = z / (1. - std::exp(-2. * z * w * parameters.duration));
          const double sa      = target.at(f) / 3.;
          const double rest    = std::max(sa * sa - below, 0.01 * sa * sa);
          const double density = rest / (w * (M_PI / (4. * zs) - 1.));
          below += density * dw;
          amplitude[k] = std::sqrt(2. * density * dw);
        }
      return amplitude;
    }


    /// Multiply the amplitudes by target over response, interpolated between the control points.
    void correct_amplitudes(const SpectrumFit   &fit,
                            const Synthesis     &synthesis,
                            const std::size_t    first,
                            std::vector<double> &amplitude)
    {
      const std::size_t n     = fit.frequency.size();
      const double      steps = (n - 1) / std::log(fit.frequency.back() / fit.frequency.front());
      for (std::size_t k = first; k < amplitude.size(); ++k)
        {
          const double x =
            std::min(std::max(steps * std::log(synthesis.frequency(k) / fit.frequency.front()), 0.),
                     n - 1.000001);
          const std::size_t i = static_cast<std::size_t>(x);
          const auto ratio    = [&](const std::size_t j) { return fit.target[j] / fit.reached[j]; };
          amplitude[k] *= ratio(i) * std::pow(ratio(i + 1) / ratio(i), x - i);
        }
    }


    /// What is to be small: the mean counts, and single frequencies that are far off.
    double badness(const SpectrumFit &fit)
    {
      return fit.mean_misfit() + 0.2 * fit.largest_misfit();
    }


    void refuse(const std::string &name, const double value, const std::string &allowed)
    {
      std::ostringstream sentence;
      sentence << "Motion/" << name << " is " << value << "; a spectrum-compatible motion needs "
               << allowed << ".";
      throw InputError(sentence.str());
    }


    void take_spectrum(const MotionParameters &parameters, InputMotion &input)
    {
      SpectrumMotion made = make_spectrum_motion(parameters);
      input.motion        = std::move(made.motion);
      input.fit           = std::move(made.fit);
      std::string fit = "the motion has the spectrum of " + parameters.spectrum_file + " from " +
                        in_words(input.fit.frequency.front()) + " to " +
                        in_words(input.fit.frequency.back()) + " Hz with a mean misfit of " +
                        in_words(100. * input.fit.mean_misfit()) + " %, at most " +
                        in_words(100. * input.fit.largest_misfit()) + " %";
      if (parameters.peak > 0.)
        fit += "; scaled to Motion/Peak it has " +
               in_words(parameters.peak / input.motion.peak_acceleration()) +
               " times that spectrum";
      if (input.fit.mean_misfit() <= 0.05)
        input.notes.push_back(fit);
      else
        input.warnings.push_back(fit + "; try a longer Motion/Duration or another Motion/Seed");
    }


    void check_spectrum(const MotionParameters &motion, const ParameterTable &table)
    {
      if (motion.spectrum_file.empty())
        throw table.error("Motion/Spectrum file",
                          "Motion/Type = spectrum needs the file of a spectrum");
      check_frequency_band(motion, table);
    }
  } // namespace


  double SpectrumFit::mean_misfit() const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < target.size(); ++i)
      sum += std::abs(reached[i] / target[i] - 1.);
    return sum / target.size();
  }


  double SpectrumFit::largest_misfit() const
  {
    double largest = 0.;
    for (std::size_t i = 0; i < target.size(); ++i)
      largest = std::max(largest, std::abs(reached[i] / target[i] - 1.));
    return largest;
  }


  SpectrumFit fit_spectrum(const Motion           &motion,
                           const ResponseSpectrum &target,
                           const double            damping,
                           const double            lowest,
                           const double            highest,
                           const int               points)
  {
    SpectrumFit fit;
    fit.damping = damping;
    for (int i = 0; i < points; ++i)
      {
        const double f = lowest * std::pow(highest / lowest, double(i) / (points - 1));
        fit.frequency.push_back(f);
        fit.target.push_back(target.at(f));
        fit.reached.push_back(spectral_acceleration(motion, f, damping));
      }
    return fit;
  }


  SpectrumMotion make_spectrum_motion(const MotionParameters &parameters)
  {
    const ResponseSpectrum target = read_response_spectrum(parameters.spectrum_file,
                                                           parameters.spectrum_by_frequency,
                                                           parameters.file_unit);
    const double lowest  = std::max(parameters.lowest_frequency, target.lowest_frequency());
    const double highest = std::min(parameters.highest_frequency, target.highest_frequency());
    if (!(highest > lowest))
      refuse("Highest frequency",
             parameters.highest_frequency,
             "a band that overlaps that of the spectrum file");
    if (!(parameters.duration * lowest >= 2.))
      refuse("Duration", parameters.duration, "at least two periods of the lowest frequency");
    if (!(samples_per_period * highest * parameters.duration <= max_samples))
      refuse("Duration", parameters.duration, "at most 10000 periods of the highest frequency");

    Synthesis                 synthesis(parameters, highest);
    const std::size_t         first = std::max(1., std::ceil(lowest / synthesis.spacing() - 1e-9));
    const std::size_t         last  = std::floor(highest / synthesis.spacing() + 1e-9);
    const std::vector<double> start =
      starting_amplitudes(target, parameters, synthesis, first, last);
    RandomNumbers  random(static_cast<std::uint64_t>(parameters.seed));
    SpectrumMotion best;
    for (int set = 0; set < sets_of_phases; ++set)
      {
        std::vector<double> amplitude = start, phase(start.size());
        for (double &p : phase)
          p = 2. * M_PI * random.uniform();
        for (int i = 0; i < iterations; ++i)
          {
            SpectrumMotion trial;
            trial.motion = synthesis.make(amplitude, phase);
            trial.fit    = fit_spectrum(
              trial.motion, target, parameters.spectrum_damping, lowest, highest, control_points);
            correct_amplitudes(trial.fit, synthesis, first, amplitude);
            if (best.motion.empty() || badness(trial.fit) < badness(best.fit))
              best = std::move(trial);
          }
        if (badness(best.fit) < good_misfit)
          break;
      }
    return best;
  }



  MotionSource spectrum_source()
  {
    return {"spectrum",
            [](const MotionParameters &parameters, double, InputMotion &input) {
              take_spectrum(parameters, input);
            },
            check_spectrum,
            "of the spectrum"};
  }
} // namespace hybrid::scene
