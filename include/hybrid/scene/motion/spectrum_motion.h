// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/motion/motion_source.h>
#include <hybrid/scene/motion/response_spectrum.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <vector>

namespace hybrid::scene
{
  /// How well a motion has the spectrum that was asked for, at frequencies from low to high.
  struct SpectrumFit
  {
    double              damping = 0.; ///< of critical [-]
    std::vector<double> frequency;    ///< [Hz], equally spaced on a log scale
    std::vector<double> target;       ///< pseudo-acceleration [m/s2]
    std::vector<double> reached;      ///< the same of the motion [m/s2]

    /// Mean of |reached / target - 1| [-].
    double mean_misfit() const;

    /// Largest |reached / target - 1| [-].
    double largest_misfit() const;
  };


  /// A motion and its fit.
  struct SpectrumMotion
  {
    Motion      motion;
    SpectrumFit fit;
  };


  /**
   * Artificial accelerogram that is compatible with the response spectrum in
   * parameters.spectrum_file, from the lowest to the highest frequency as far as the file has them.
   *
   * Sinusoids of random phase (seed) with the amplitudes of the spectrum-compatible power spectrum
   * (Gasparini & Vanmarcke 1976, SIMQKE), times earthquake_envelope(), baseline-corrected if asked
   * for; then the amplitudes are multiplied by target over response and so on, 60 times; the
   * best motion is kept. The fit is that of the returned motion.
   */
  SpectrumMotion make_spectrum_motion(const MotionParameters &parameters);


  /// It as a source of motions, with a word on the fit.
  MotionSource spectrum_source();


  /// Fit of @p motion to @p target between two frequencies [Hz].
  SpectrumFit fit_spectrum(const Motion           &motion,
                           const ResponseSpectrum &target,
                           double                  damping,
                           double                  lowest,
                           double                  highest,
                           int                     points);
} // namespace hybrid::scene
