// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/motion_answer.h>

#include <complex>
#include <cstddef>
#include <vector>

namespace hybrid::output
{
  /**
   * How a recorded motion changes if the model takes each frequency for a slightly different one.
   *
   * A linear model that is driven by F(s) moves by U = H(s) F. Computed in steps, or on a mesh, it
   * moves by H(s + d) F, so the error is d(s) H'(s) F. H' is had from what a run records: h(t) is
   * the answer to a pulse (MotionAnswer), and H' the transform of -t h(t). t h(t) counts every wave
   * with the time that it has been on its way, all its reflections and the ringing of layers
   * included.
   *
   * The error up to the end of a record is (-t h) * (d F), of lags and a source within it. d is a
   * few derivatives: they are taken of F, which is known beyond the end, and not of U, which is
   * not. So it does not matter whether a record ends within the motion.
   *
   * What is left of U is taken for waves that were set off within the model one radian ago: R/s is
   * added to H' F, with R = U - H F.
   */
  class ResponseDelay
  {
  public:
    using Spectrum = MotionAnswer::Spectrum;

    /// @param spacing [s]. @param source velocity of what shakes, one per row of a record and as
    /// many of what follows, any unit; all zero in the record: the model is set off at t = 0, by
    /// its initial state or by a load that begins.
    ResponseDelay(double spacing, const std::vector<double> &source);

    /// s = i w of the entries of a spectrum [1/s].
    const Spectrum &frequencies() const
    {
      return s;
    }

    /// Rows of a record.
    std::size_t n_rows() const
    {
      return rows;
    }

    struct Delay
    {
      Spectrum spectrum;         ///< H' F
      double   left_at_end = 0.; ///< largest |U - H F| in the last tenth of the record [m/s]
    };

    /// H' F of a velocity, one per row of a record.
    Delay delay(const std::vector<double> &velocity) const;

    /// The change of the velocity: d H' F in time, one per row of a record.
    std::vector<double> change(const Spectrum &delay, const Spectrum &frequency_change) const;

  private:
    double       spacing;
    std::size_t  rows, length; ///< of a record; of its transform, a power of two
    bool         is_set_off;   ///< at t = 0
    Spectrum     s;
    Spectrum     source_spectrum; ///< fades out beyond the record
    MotionAnswer answer;

    Spectrum            forward(const std::vector<double> &history) const;
    std::vector<double> backward(const Spectrum &spectrum) const;
  };
} // namespace hybrid::output
