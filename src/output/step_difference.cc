// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/step_difference.h>
#include <hybrid/scene/motion/filter.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr double least_motion = 1e-3; ///< of the largest [-]
    constexpr double least_order  = 0.25;
    constexpr double middle_order =
      1.45; ///< where 2^p - 1 is sqrt(3), between 1 (first order) and 3 (second)

    using History = std::vector<double>;

    /// Displacement relative to the base, velocity and acceleration of one monitor, filtered.
    using Histories = std::array<std::array<History, 2>, 3>;



    /// Times that two runs are compared at.
    struct Rows
    {
      double      begin, spacing; // [s]
      std::size_t count;
    };



    /// One component of a history (pairs), linear between its times.
    History
    sample(const History &time, const History &pairs, const std::size_t component, const Rows &rows)
    {
      History     result(rows.count);
      std::size_t i = 0;
      for (std::size_t row = 0; row < rows.count; ++row)
        {
          const double t = rows.begin + row * rows.spacing;
          while (i + 2 < time.size() && time[i + 1] <= t)
            ++i;
          const double weight = std::min((t - time[i]) / (time[i + 1] - time[i]), 1.);
          result[row] =
            (1. - weight) * pairs[2 * i + component] + weight * pairs[2 * (i + 1) + component];
        }
      return result;
    }



    std::vector<Histories> histories(const StepRecord &record, const Rows &rows)
    {
      std::vector<Histories> result(record.monitors.size());
      for (std::size_t c = 0; c < 2; ++c)
        {
          History base(rows.count, 0.);
          if (record.base >= 0)
            base = sample(record.time, record.monitors[record.base].histories[0], c, rows);
          for (std::size_t m = 0; m < result.size(); ++m)
            for (std::size_t q = 0; q < 3; ++q)
              {
                History x = sample(record.time, record.monitors[m].histories[q], c, rows);
                if (q == 0)
                  for (std::size_t i = 0; i < rows.count; ++i)
                    x[i] -= base[i];
                result[m][q][c] = scene::low_pass(x, rows.spacing, record.corner);
              }
        }
      return result;
    }



    double largest_size(const std::array<History, 2> &x)
    {
      double result = 0.;
      for (std::size_t i = 0; i < x[0].size(); ++i)
        result = std::max(result, std::hypot(x[0][i], x[1][i]));
      return result;
    }



    double largest_difference(const std::array<History, 2> &x, const std::array<History, 2> &y)
    {
      double result = 0.;
      for (std::size_t i = 0; i < x[0].size(); ++i)
        result = std::max(result, std::hypot(x[0][i] - y[0][i], x[1][i] - y[1][i]));
      return result;
    }



    /// What both runs have before the first of them ends or breaks.
    Rows common_rows(const StepRecord &longer, const StepRecord &shorter)
    {
      const double begin = std::max(longer.time.front(), shorter.time.front());
      double       end   = std::min(longer.time.back(), shorter.time.back());
      for (const double until : {longer.until, shorter.until})
        end = std::fmin(end, until);
      const double spacing = (longer.time.back() - longer.time.front()) / (longer.time.size() - 1);
      return {begin,
              spacing,
              static_cast<std::size_t>(std::max(std::floor((end - begin) / spacing + 1e-6), 0.))};
    }



    bool have_the_same_monitors(const StepRecord &one, const StepRecord &other)
    {
      return std::equal(one.monitors.begin(),
                        one.monitors.end(),
                        other.monitors.begin(),
                        other.monitors.end(),
                        [](const auto &a, const auto &b) { return a.name == b.name; });
    }



    /// Displacement or velocity, whichever is farther off; one of them may be unknown.
    double deciding(const std::array<double, 3> &part)
    {
      return std::fmax(part[0], part[1]);
    }
  } // namespace



  Summary::ErrorPart step_difference(const StepRecord &longer, const StepRecord &shorter)
  {
    Summary::ErrorPart result;
    const Rows         rows = common_rows(longer, shorter);
    if (!have_the_same_monitors(longer, shorter) || rows.count < 2)
      return result;
    const std::vector<Histories> before = histories(longer, rows), now = histories(shorter, rows);
    for (int q = 0; q < 3; ++q)
      {
        double largest = 0.;
        for (const Histories &monitor : now)
          largest = std::max(largest, largest_size(monitor[q]));
        for (std::size_t m = 0; m < now.size(); ++m)
          {
            const double peak = largest_size(now[m][q]);
            if ((q == 0 && int(m) == shorter.base) || !(peak > least_motion * largest))
              continue;
            const double part = largest_difference(before[m][q], now[m][q]) / peak;
            if (!(part <= result.part[q])) // NaN: none yet
              {
                result.part[q]  = part;
                result.where[q] = shorter.monitors[m].name;
              }
          }
      }
    return result;
  }



  void measure_error(const StepRecord &longer, StepRecord &shorter, Summary::ProbableError &error)
  {
    const Summary::ErrorPart difference = step_difference(longer, shorter);
    shorter.difference                  = difference.part;
    const double ratio = longer.step / shorter.step, now = deciding(difference.part);
    if (!(ratio > 1.))
      return;            // the record of something else
    if (std::isnan(now)) // nothing moves, or a joint failed at once
      {
        error.runs_would_do = false;
        return;
      }
    const double order = std::log(deciding(longer.difference) / now) / std::log(ratio);
    error.reason.clear();
    error.measured_from = longer.step;
    error.until         = std::fmin(longer.until, shorter.until);
    error.step = error.half_step = difference;
    if (order < least_order) // NaN: there is no third run
      return;
    for (int q = 0; q < 3; ++q)
      {
        const double found = std::log(longer.difference[q] / difference.part[q]) / std::log(ratio);
        const double p =
          std::isnan(found) ? middle_order : std::clamp(found, least_order, middle_order);
        error.step.part[q] /= std::pow(ratio, p) - 1.;
        error.half_step.part[q] = error.step.part[q] * std::pow(0.5, p);
      }
  }
} // namespace hybrid::output
