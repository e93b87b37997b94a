// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace hybrid::output
{
  /**
   * The answer h(t) of a linear model to a pulse, from a record of what shakes it, F, and of how it
   * moves, U.
   *
   * Nothing answers before it is asked, so U(t) = integral of h(t') F(t - t') over lags 0 <= t' <=
   * t: what a record has tells h up to its own length, wherever it ends, and nothing need be known
   * of what follows. h minimises
   *   |U - h * F|^2 + w |h|^2 within the record, w = 1e-4 of the largest |F(s)|^2
   * (Tikhonov 1963) by conjugate gradients on the normal equations (Hestenes & Stiefel 1952), which
   * end when the gradient is a thousandth of the first one: later directions are noise.
   *
   * Lags are no longer than they need be: a 64th of the record, a 16th, a quarter or all of it, the
   * first that leaves less than 5 % of U. What is no answer to F averages out over the record the
   * more, the shorter they are. (With all lags, motions of 20 s in steps of 8 ms were told up to 20
   * times too large an error.)
   */
  class MotionAnswer
  {
  public:
    using Spectrum = std::vector<std::complex<double>>;

    /// @param source F, one per row.
    explicit MotionAnswer(const std::vector<double> &source);

    struct Answer
    {
      std::vector<double> pulse; ///< h per row, of lags from 0 on, as many as the record has
      std::vector<double> rest;  ///< U - h * F
    };

    /// @param velocity U, one per row.
    Answer find(const std::vector<double> &velocity) const;

  private:
    std::vector<double> source;
    std::vector<double> autocorrelation; ///< of the source, by lags
    double              weight = 0.;     ///< w
    Spectrum            spectrum;        ///< of the source with as many zeros
  };
} // namespace hybrid::output
