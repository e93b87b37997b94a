// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace hybrid::output
{
  /**
   * How a recorded motion changes if the model takes each frequency for a slightly different one.
   *
   * A linear model that is driven by F(s) moves by U = H(s) F. Computed in steps, or on a mesh, it
   * moves by H(s + d) F, so the error is d(s) H'(s) F. H' is had from what a run records: h(t) =
   * U/F is the answer to a pulse, and H' the transform of -t h(t). t h(t) counts every wave with
   * the time that it has been on its way, all its reflections and the ringing of layers included.
   *
   * U/F is found from the correlations of both, windowed at the lag L (Blackman & Tukey 1958) by
   * exp(-2 (t/L)^2): what is no answer to F (slip, cracks) averages out over the record. L is the
   * record less the 5 to 95 % duration of F, at least a quarter of the record. Up to twice of what
   * the window takes from a lag is given back. Both go on beyond the end of the record, to nothing
   * over a twentieth of it: what still rings there would jump, and a jump has all frequencies, F
   * hardly any of the high ones.
   *
   * What has not averaged out is as large before a pulse, where nothing can answer it, as after it.
   * So h is multiplied by 1 - N/A, A its mean square about the lag t and N that about -t (Wiener
   * 1949), and h(t < 0) is left out. The rest of the motion, R = U - H F, is taken for waves that
   * were set off within the model one radian ago: R/s is added to H' F. What moves with F, within
   * its mean period, is no part of R.
   */
  class ResponseDelay
  {
  public:
    using Spectrum = std::vector<std::complex<double>>;

    /// @param spacing [s]. @param source velocity of what shakes, one per row, any unit; all zero:
    /// the model is set off at t = 0, by its initial state or by a load that begins.
    ResponseDelay(double spacing, const std::vector<double> &source);

    /// s = i w of the entries of a spectrum [1/s].
    const Spectrum &frequencies() const
    {
      return s;
    }

    /// H' F of a velocity, as many rows as the source.
    Spectrum delay(const std::vector<double> &velocity) const;

    /// The change of the velocity: d H' F in time, one per row.
    std::vector<double> change(const Spectrum &delay, const Spectrum &frequency_change) const;

  private:
    double              spacing;
    std::size_t         rows, length; ///< of a record; of its transform, a power of two
    bool                is_set_off;   ///< at t = 0
    double              reach  = 0.;  ///< L [s]
    double              period = 0.;  ///< mean one of the source [s]
    Spectrum            s;
    Spectrum            source_spectrum;
    std::vector<double> denominator; ///< |F|^2 windowed, never below 1e-4 of its largest
    std::vector<double> window;      ///< of each lag
    std::vector<double> lag; ///< of each row of a transform, negative in the second half [s]

    Spectrum            forward(const std::vector<double> &history) const;
    std::vector<double> backward(const Spectrum &spectrum) const;
    Spectrum            windowed(const Spectrum &correlation) const;

    /// h of a velocity, one per lag.
    std::vector<double> answer(const std::vector<double> &velocity) const;

    /// What is larger after the pulse than before it.
    std::vector<double> without_noise(const std::vector<double> &pulse) const;

    /// R, with the answer @p pulse, without noise @p clear.
    Spectrum no_answer(const std::vector<double> &velocity,
                       const std::vector<double> &pulse,
                       std::vector<double>        clear) const;

    void make_window(const std::vector<double> &source);
  };
} // namespace hybrid::output
