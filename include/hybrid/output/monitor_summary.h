// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/summary.h>

#include <array>
#include <vector>

namespace hybrid::output
{
  /// What all monitors of a run are judged by. Arrays of pairs are flat: x0, y0, x1, y1, ...
  struct MonitorReference
  {
    std::vector<double> time;                 ///< increasing, steps may differ [s]
    std::vector<double> outcrop_acceleration; ///< pairs [m/s2]; empty: no amplification
    std::vector<double>
           base_displacement; ///< pairs, of the base monitor [m]; empty: absolute displacements
    double filter_frequency   = 25.; ///< corner of the zero-phase low-pass [Hz]; 0: none
    double first_failure_time = MonitorSummary::unknown; ///< NaN: nothing failed [s]
  };


  /**
   * Peaks and amplification of monitors from their raw histories.
   *
   * Raw accelerations of blocks in contact depend on penalty and step, so every peak is taken after
   * the zero-phase low-pass. Histories whose steps differ (cut steps) are first interpolated
   * linearly to equal spacing. Peaks keep their sign. Amplification is |peak| over the outcrop's
   * |peak|, both filtered, by component; the one up to the first failure takes both over that part
   * of the run only. A component in which the outcrop does not move has none (NaN).
   */
  class MonitorSummarizer
  {
  public:
    using Pair = MonitorSummary::Pair;

    explicit MonitorSummarizer(MonitorReference reference);

    /// @param displacement absolute [m], @param velocity [m/s], @param acceleration [m/s2]: pairs,
    /// one per time.
    MonitorSummary summarize(const std::vector<double> &displacement,
                             const std::vector<double> &velocity,
                             const std::vector<double> &acceleration) const;

    /// Filtered peak of the outcrop acceleration over the whole run [m/s2]; NaN without a motion.
    Pair outcrop_peak() const
    {
      return outcrop_peak_total;
    }

    /// Signed value of largest magnitude after the low-pass, of the rows [0, n_rows) of @p pairs.
    Pair filtered_peak(const std::vector<double> &pairs, std::size_t n_rows) const;

    /// Times of filtered(): the given ones, or as many at equal spacing as they reach [s].
    std::vector<double> filtered_time() const;

    /// All of @p pairs after the low-pass: pairs, one per filtered_time().
    std::vector<double> filtered(const std::vector<double> &pairs) const;

  private:
    /// Rows at equal spacing that n_rows of the given times reach.
    std::size_t n_equal_rows(std::size_t n_rows) const;

    /// One component of the first n_rows rows at equal spacing, filtered.
    std::vector<double>
    filtered(const std::vector<double> &pairs, int component, std::size_t n_rows) const;

    MonitorReference reference;
    double           spacing         = 0.; ///< after interpolation [s]
    bool             has_equal_steps = true;
    std::size_t      n_until_failure = 0; ///< rows up to the first failure
    Pair             outcrop_peak_total;
    Pair             outcrop_peak_until_failure;
  };
} // namespace hybrid::output
