// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * Pseudo-acceleration w^2 max|u| [m/s2] of an oscillator of frequency @p f [Hz] and @p damping
   * of critical on ground that moves with @p motion: u'' + 2 z w u' + w^2 u = -a(t), from rest.
   *
   * Exact for the motion, whose acceleration is linear between its samples (recurrence of Nigam
   * & Jennings 1969), sampled at least 60 times per period of the oscillator, and followed for
   * one more period after the motion's end.
   */
  double spectral_acceleration(const Motion &motion, double f, double damping);


  /// A design spectrum: pseudo-acceleration over frequency, log-log interpolated.
  class ResponseSpectrum
  {
  public:
    ResponseSpectrum() = default;

    /// @param frequencies rising [Hz], > 0.  @param accelerations [m/s2], > 0; as many, two or
    /// more.
    ResponseSpectrum(std::vector<double> frequencies, std::vector<double> accelerations);

    /// [m/s2]; beyond the ends the value of the end.
    double at(double frequency) const;

    bool empty() const
    {
      return f.empty();
    }

    double lowest_frequency() const
    {
      return f.front();
    }

    double highest_frequency() const
    {
      return f.back();
    }

  private:
    std::vector<double> f; ///< [Hz]
    std::vector<double> a; ///< [m/s2]
  };


  /**
   * Read a spectrum of two columns, period [s] (or frequency [Hz] if @p by_frequency) and
   * acceleration in @p unit [m/s2], in either direction. A row of period 0 (peak ground
   * acceleration) is passed over: no oscillator has it.
   * @throws InputError with file and line.
   */
  ResponseSpectrum read_response_spectrum(const std::string &file, bool by_frequency, double unit);
} // namespace hybrid::scene
