// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/monitor_summary.h>
#include <hybrid/scene/motion/filter.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr MonitorSummary::Pair unknown_pair = {
      {MonitorSummary::unknown, MonitorSummary::unknown}};

    /// Steps that differ by less than this part count as equal (sums of decimal fractions).
    constexpr double equal_step_tolerance = 1e-6;

    /// A run with few cut steps is not refined to the smallest one throughout: at most so many
    /// times its rows.
    constexpr double largest_refinement = 4.;

    /// Below this part of the larger component the outcrop counts as at rest (cos 90 deg is not
    /// zero).
    constexpr double rest_ratio = 1e-9;


    MonitorSummary::Pair amplification(const MonitorSummary::Pair &peak,
                                       const MonitorSummary::Pair &outcrop)
    {
      const double         largest = std::fmax(std::abs(outcrop[0]), std::abs(outcrop[1]));
      MonitorSummary::Pair result  = unknown_pair;
      for (int c = 0; c < 2; ++c)
        if (std::abs(outcrop[c]) > rest_ratio * largest)
          result[c] = std::abs(peak[c]) / std::abs(outcrop[c]);
      return result;
    }
  } // namespace



  MonitorSummarizer::MonitorSummarizer(MonitorReference given)
    : reference(std::move(given))
    , n_until_failure(reference.time.size())
    , outcrop_peak_total(unknown_pair)
    , outcrop_peak_until_failure(unknown_pair)
  {
    const std::vector<double> &time = reference.time;
    if (time.size() >= 2)
      {
        double smallest = time[1] - time[0], largest = smallest;
        for (std::size_t i = 2; i < time.size(); ++i)
          {
            smallest = std::min(smallest, time[i] - time[i - 1]);
            largest  = std::max(largest, time[i] - time[i - 1]);
          }
        const double mean = (time.back() - time.front()) / (time.size() - 1);
        has_equal_steps   = largest - smallest <= equal_step_tolerance * largest;
        spacing           = has_equal_steps ? mean : std::max(smallest, mean / largest_refinement);
      }
    if (std::isfinite(reference.first_failure_time))
      n_until_failure =
        std::upper_bound(time.begin(), time.end(), reference.first_failure_time) - time.begin();
    if (!reference.outcrop_acceleration.empty())
      {
        outcrop_peak_total         = filtered_peak(reference.outcrop_acceleration, time.size());
        outcrop_peak_until_failure = filtered_peak(reference.outcrop_acceleration, n_until_failure);
      }
  }



  std::size_t MonitorSummarizer::n_equal_rows(const std::size_t n_rows) const
  {
    if (has_equal_steps || n_rows < 2)
      return n_rows;
    const double duration = reference.time[n_rows - 1] - reference.time[0];
    return static_cast<std::size_t>(duration / spacing + 1e-9) + 1;
  }



  std::vector<double> MonitorSummarizer::filtered_time() const
  {
    if (has_equal_steps)
      return reference.time;
    std::vector<double> time(n_equal_rows(reference.time.size()));
    for (std::size_t i = 0; i < time.size(); ++i)
      time[i] = reference.time[0] + i * spacing;
    return time;
  }



  std::vector<double> MonitorSummarizer::filtered(const std::vector<double> &pairs) const
  {
    const std::vector<double> x = filtered(pairs, 0, reference.time.size()),
                              y = filtered(pairs, 1, reference.time.size());
    std::vector<double> result;
    for (std::size_t i = 0; i < x.size(); ++i)
      result.insert(result.end(), {x[i], y[i]});
    return result;
  }



  std::vector<double> MonitorSummarizer::filtered(const std::vector<double> &pairs,
                                                  const int                  component,
                                                  const std::size_t          n_rows) const
  {
    assert(pairs.size() >= 2 * n_rows);
    std::vector<double>        series;
    const std::vector<double> &time = reference.time;
    if (has_equal_steps || n_rows < 2)
      for (std::size_t i = 0; i < n_rows; ++i)
        series.push_back(pairs[2 * i + component]);
    else
      {
        const std::size_t n   = n_equal_rows(n_rows);
        std::size_t       row = 0;
        for (std::size_t i = 0; i < n; ++i)
          {
            const double t = time[0] + i * spacing;
            while (row + 2 < n_rows && time[row + 1] <= t)
              ++row;
            const double weight = std::min((t - time[row]) / (time[row + 1] - time[row]), 1.);
            series.push_back((1. - weight) * pairs[2 * row + component] +
                             weight * pairs[2 * (row + 1) + component]);
          }
      }
    if (series.size() < 2)
      return series;
    return scene::low_pass(series, spacing, reference.filter_frequency);
  }



  MonitorSummarizer::Pair MonitorSummarizer::filtered_peak(const std::vector<double> &pairs,
                                                           const std::size_t          n_rows) const
  {
    if (n_rows == 0)
      return unknown_pair;
    Pair peak = {{0., 0.}};
    for (int c = 0; c < 2; ++c)
      for (const double value : filtered(pairs, c, n_rows))
        if (std::abs(value) > std::abs(peak[c]) || std::isnan(value))
          peak[c] = value;
    return peak;
  }



  MonitorSummary MonitorSummarizer::summarize(const std::vector<double> &displacement,
                                              const std::vector<double> &velocity,
                                              const std::vector<double> &acceleration) const
  {
    const std::size_t n = reference.time.size();
    MonitorSummary    summary;
    if (n == 0)
      return summary;

    std::vector<double> relative = displacement;
    if (!reference.base_displacement.empty())
      for (std::size_t i = 0; i < relative.size(); ++i)
        relative[i] -= reference.base_displacement[i];

    summary.peak_displacement  = filtered_peak(relative, n);
    summary.peak_velocity      = filtered_peak(velocity, n);
    summary.peak_acceleration  = filtered_peak(acceleration, n);
    summary.final_displacement = {{relative[2 * n - 2], relative[2 * n - 1]}};
    summary.amplification      = amplification(summary.peak_acceleration, outcrop_peak_total);
    summary.amplification_until_first_failure =
      amplification(filtered_peak(acceleration, n_until_failure), outcrop_peak_until_failure);
    return summary;
  }
} // namespace hybrid::output
