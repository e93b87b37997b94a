// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

namespace hybrid
{
  /**
   * A generalised Maxwell body: a spring and some branches of spring and dashpot beside it. Its
   * modulus, over that of the material, is
   *
   *     m(w) = relaxed + sum_l weight_l i w t_l / (1 + i w t_l)
   *
   * (Emmerich and Korn 1987, eq. 9 and 11). Over a band of frequencies the ratio of imaginary and
   * real part, 1/Q, is twice a damping ratio. A body that damps is the softer the slower it is
   * strained; a plane wave of the band's geometric middle has the material's phase velocity.
   *
   * In a step of dt a branch follows the trapezoidal rule: of its spring's strain s
   *
   *     s1 = kept s0 + gained (e1 - e0),  kept = (1 - x/2)/(1 + x/2),  gained = 1/(1 + x/2)
   *
   * with x = dt / t_l. Its dashpot takes x M (s0 + s1)^2 / 4 then, which is never negative, and
   * with the change of M s^2 / 2 this is exactly the work of the branch's mean stress.
   */
  struct MaxwellBody
  {
    double              relaxed = 1.; ///< long-term modulus over the material's [-], (0, 1]
    std::vector<double> time;         ///< t_l [s], longest first; empty: elastic
    std::vector<double> weight;       ///< modulus of each branch over the material's [-], >= 0

    std::size_t n_branches() const
    {
      return time.size();
    }

    double kept(const double dt, const std::size_t l) const
    {
      return (1. - 0.5 * dt / time[l]) / (1. + 0.5 * dt / time[l]);
    }

    double gained(const double dt, const std::size_t l) const
    {
      return 1. / (1. + 0.5 * dt / time[l]);
    }

    /// What stress has beyond the elastic one, over the modulus, per strain that a step adds [-]:
    /// relaxed - 1 + sum_l weight_l gained_l.
    double step_modulus(double dt) const;

    /// m at the circular frequency @p omega [rad/s].
    std::complex<double> modulus(double omega) const;

    /// Half of 1/Q at the circular frequency @p omega [-].
    double damping_ratio(double omega) const;
  };


  /// Frequencies from lowest to highest [Hz].
  struct FrequencyBand
  {
    double lowest, highest;
  };


  /**
   * The body whose damping ratio is nearest to @p ratio over the band. Relaxation times are equally
   * far apart on a logarithmic scale about the band's middle; the weights are those of least
   * squares, linear in them, none negative (Emmerich and Korn 1987, eq. 24; Moczo and Kristek
   * 2005); the spacing is the one with the least largest error.
   * @param ratio of critical, [0, 0.25] [-]; 0: an elastic body
   */
  MaxwellBody maxwell_body(double ratio, const FrequencyBand &band, int branches);


  /// Largest deviation of the body's damping ratio from @p ratio over the band, relative to it [-].
  double ratio_error(const MaxwellBody &body, double ratio, const FrequencyBand &band);
} // namespace hybrid
