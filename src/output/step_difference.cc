// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/filter_reach.h>
#include <hybrid/output/formatted.h>
#include <hybrid/output/step_difference.h>
#include <hybrid/scene/motion/filter.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr double least_slip   = 1e-2; ///< of the largest displacement [-]
    constexpr double least_order  = 0.25; ///< of differences; below, runs scatter
    constexpr double first_order  = 1.;   ///< differences that fall more slowly do so by chance
    constexpr double least_excess = 0.05; ///< of a peak at an end over the others, to be told
    constexpr double least_ratio  = 1.5;  ///< of steps that were taken, for a difference that tells
    constexpr double most_alike   = 0.05; ///< of the time, in steps with less than this ratio

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



    /// What is known at the times of some rows, at those of others.
    History resample(const Rows &known, const History &x, const Rows &rows)
    {
      History result(rows.count);
      for (std::size_t row = 0; row < rows.count; ++row)
        {
          const double at =
            std::max((rows.begin - known.begin + row * rows.spacing) / known.spacing, 0.);
          const std::size_t i      = std::min(static_cast<std::size_t>(at), known.count - 2);
          const double      weight = std::min(at - static_cast<double>(i), 1.);
          result[row]              = (1. - weight) * x[i] + weight * x[i + 1];
        }
      return result;
    }



    /// Up to @p end [s], as many as the run has steps there: what steps have above the corner must
    /// not look like what is below it.
    Rows rows_of(const StepRecord &record, const double end)
    {
      const double begin = record.time.front();
      const auto   steps = std::count_if(record.time.begin() + 1,
                                       record.time.end(),
                                       [&](const double t) { return t < end + 0.5 * record.step; });
      const auto   count = std::max<std::size_t>(steps, 1);
      return {begin, (end - begin) / count, count + 1};
    }



    /// Displacement relative to the base, velocity or acceleration of a monitor, as pairs.
    History motion(const StepRecord &record, const std::size_t monitor, const std::size_t quantity)
    {
      History pairs = record.monitors[monitor].histories[quantity];
      if (quantity == 0 && record.base >= 0)
        for (std::size_t i = 0; i < pairs.size(); ++i)
          pairs[i] -= record.monitors[record.base].histories[0][i];
      return pairs;
    }



    /// At the times of @p rows, filtered up to @p end [s].
    std::vector<Histories> histories(const StepRecord &record, const Rows &rows, const double end)
    {
      const Rows             own = rows_of(record, end);
      std::vector<Histories> result(record.monitors.size());
      for (std::size_t m = 0; m < result.size(); ++m)
        for (std::size_t q = 0; q < 3; ++q)
          for (std::size_t c = 0; c < 2; ++c)
            {
              const History x = sample(record.time, motion(record, m, q), c, own);
              result[m][q][c] = resample(own, scene::low_pass(x, own.spacing, record.corner), rows);
            }
      return result;
    }



    /// Rows from one to before another.
    struct Range
    {
      std::size_t begin, end;
    };



    /// Where a quantity is compared, of histories that are filtered up to @p end [s]:
    /// accelerations only where the filter has something to look at on both sides.
    Range
    compared(const Rows &rows, const std::size_t quantity, const double corner, const double end)
    {
      if (quantity < 2)
        return {0, rows.count};
      constexpr double rounding = 1e-6;
      const double     length = end - rows.begin, reach = filter_reach(corner, length);
      const auto       first = static_cast<std::size_t>(std::ceil(reach / rows.spacing - rounding));
      const auto last = static_cast<std::size_t>((length - reach) / rows.spacing + rounding) + 1;
      return {first, std::min(last, rows.count)};
    }



    double largest_size(const std::array<History, 2> &x, const Range &range)
    {
      double result = 0.;
      for (std::size_t i = range.begin; i < range.end; ++i)
        result = std::max(result, std::hypot(x[0][i], x[1][i]));
      return result;
    }



    double largest_difference(const std::array<History, 2> &x,
                              const std::array<History, 2> &y,
                              const Range                  &range)
    {
      double result = 0.;
      for (std::size_t i = range.begin; i < range.end; ++i)
        result = std::max(result, std::hypot(x[0][i] - y[0][i], x[1][i] - y[1][i]));
      return result;
    }



    /// One time [s] is before another; NaN: never.
    bool is_before(const double one, const double other)
    {
      return one < other || (std::isnan(other) && !std::isnan(one));
    }



    /// Where the first of two runs ends, or a step before it breaks [s]: no step resolves how.
    double common_end(const StepRecord &longer, const StepRecord &shorter)
    {
      return std::fmin(std::min(longer.time.back(), shorter.time.back()),
                       std::fmin(longer.until, shorter.until) - longer.step);
    }



    /// Steps that a run has taken up to a time.
    double steps_until(const StepRecord &record, const double end)
    {
      return static_cast<double>(std::count_if(record.time.begin(),
                                               record.time.end(),
                                               [end](const double t) { return t <= end; }));
    }



    /// Part of the time before @p end in which two runs took steps of nearly one size: there the
    /// one is no better than the other.
    double part_alike(const StepRecord &longer, const StepRecord &shorter, const double end)
    {
      double      alike = 0.;
      std::size_t j     = 1; // of the shorter step in the middle of the longer one
      for (std::size_t i = 1; i < longer.time.size() && longer.time[i] <= end; ++i)
        {
          const double begin = longer.time[i - 1], step = longer.time[i] - begin;
          while (j + 1 < shorter.time.size() && shorter.time[j] < begin + 0.5 * step)
            ++j;
          if (step < least_ratio * (shorter.time[j] - shorter.time[j - 1]))
            alike += step;
        }
      return alike / (end - longer.time.front());
    }



    /// What both runs have.
    Rows common_rows(const StepRecord &longer, const StepRecord &shorter)
    {
      const double begin   = std::max(longer.time.front(), shorter.time.front());
      const double end     = common_end(longer, shorter);
      const double spacing = (longer.time.back() - longer.time.front()) / (longer.time.size() - 1);
      return {begin,
              spacing,
              static_cast<std::size_t>(std::max(std::floor((end - begin) / spacing + 1e-6), 0.))};
    }



    /// When a joint failed in the other of two runs, too [s]; NaN: none did. Within a step of the
    /// first, it is as if at once.
    double later_failure(const StepRecord &longer, const StepRecord &shorter)
    {
      constexpr double rounding = 1e-6;
      if (std::isnan(longer.until) || std::isnan(shorter.until))
        return MonitorSummary::unknown;
      const auto [first, later] = std::minmax(longer.until, shorter.until);
      return later - first < (1. + rounding) * longer.step ? first : later;
    }



    bool have_the_same_monitors(const StepRecord &one, const StepRecord &other)
    {
      return std::equal(one.monitors.begin(),
                        one.monitors.end(),
                        other.monitors.begin(),
                        other.monitors.end(),
                        [](const auto &a, const auto &b) { return a.name == b.name; });
    }



    /// Part that the mean slip that is left differs by; NaN: there is none beside the largest
    /// @p displacement, or a joint failed.
    double
    slip_difference(const StepRecord &longer, const StepRecord &shorter, const double displacement)
    {
      const double end = common_end(longer, shorter);
      const bool   are_whole =
        std::isnan(std::fmin(longer.until, shorter.until)) &&
        std::max(longer.time.back(), shorter.time.back()) - end < longer.step + shorter.step;
      return are_whole && std::abs(shorter.slip_left) > least_slip * displacement
               ? std::abs(longer.slip_left / shorter.slip_left - 1.)
               : MonitorSummary::unknown;
    }



    /// All numbers of an error.
    std::array<double *, 4> numbers(Summary::ErrorPart &error)
    {
      return {{&error.part[0], &error.part[1], &error.part[2], &error.slip_left}};
    }



    /// Displacement or velocity, whichever is farther off; one of them may be unknown.
    double deciding(const std::array<double, 3> &part)
    {
      return std::fmax(part[0], part[1]);
    }



    /// The monitor whose acceleration is larger near an end of a run, where it is not compared,
    /// than anywhere else by more than the part @p told and a twentieth; empty: none.
    std::string peaks_at_an_end(const StepRecord &run, const StepRecord &other, const double told)
    {
      const bool   is_longer = run.step > other.step;
      const Rows   rows      = is_longer ? common_rows(run, other) : common_rows(other, run);
      const double end       = std::min(run.time.back(), other.time.back());
      const Range  all{0, rows.count}, inner = compared(rows, 2, run.corner, end);
      const std::vector<Histories> of_run  = histories(run, rows, end);
      double                       largest = 0., most = 1. + std::fmax(told, least_excess);
      std::string                  result;
      for (const Histories &monitor : of_run)
        largest = std::max(largest, largest_size(monitor[2], all));
      for (std::size_t m = 0; m < of_run.size(); ++m)
        {
          const double whole   = largest_size(of_run[m][2], all);
          const double between = largest_size(of_run[m][2], inner);
          if (whole > run.least_motion * largest && whole > most * between)
            {
              most   = whole / between;
              result = run.monitors[m].name;
            }
        }
      return result;
    }



    /// Whether the difference of two runs tells the error of either; sets the reason, whether a run
    /// in yet shorter steps would, and if it does the time up to which, and the difference as the
    /// error.
    bool tells(const Summary::ErrorPart &difference,
               const StepRecord         &longer,
               const StepRecord         &shorter,
               Summary::ProbableError   &error)
    {
      if (!(longer.step > shorter.step))
        return false; // the record of something else
      const double end = common_end(longer, shorter), alike = part_alike(longer, shorter, end);
      error.reason.clear();
      const bool none_shorter = steps_until(shorter, end) < least_ratio * steps_until(longer, end);
      if (none_shorter)
        error.reason = "steps are cut, and another step hardly changes them";
      else if (alike > most_alike)
        error.reason =
          formatted("steps are cut, and for %.2g %% of the time both runs take the same",
                    100. * alike);
      else if (std::isnan(deciding(difference.part)))
        error.reason =
          std::isnan(shorter.until) ? "nothing moves" : "a joint failed in the first steps";
      const bool is_told  = error.reason.empty();
      error.runs_would_do = is_told || (alike > most_alike && !none_shorter);
      error.until         = std::fmin(longer.until, shorter.until);
      error.until_later   = later_failure(longer, shorter);
      error.step = error.half_step = difference;
      return is_told;
    }
  } // namespace



  Summary::ErrorPart step_difference(const StepRecord &longer, const StepRecord &shorter)
  {
    Summary::ErrorPart result;
    const Rows         rows = common_rows(longer, shorter);
    if (!have_the_same_monitors(longer, shorter) || rows.count < 2)
      return result;
    const double                 end    = std::min(longer.time.back(), shorter.time.back());
    const std::vector<Histories> before = histories(longer, rows, end),
                                 now    = histories(shorter, rows, end);
    const double least                  = std::max(longer.least_motion, shorter.least_motion);
    for (int q = 0; q < 3; ++q)
      {
        const Range range   = compared(rows, q, shorter.corner, end);
        double      largest = 0.;
        for (const Histories &monitor : now)
          largest = std::max(largest, largest_size(monitor[q], range));
        if (q == 0)
          result.slip_left = slip_difference(longer, shorter, largest);
        for (std::size_t m = 0; m < now.size(); ++m)
          {
            const double peak = largest_size(now[m][q], range);
            if ((q == 0 && int(m) == shorter.base) || !(peak > least * largest))
              continue;
            const double part = largest_difference(before[m][q], now[m][q], range) / peak;
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
    if (!tells(difference, longer, shorter, error))
      return;
    shorter.difference = difference.part;
    const double ratio = longer.step / shorter.step;
    const double order =
      std::log(deciding(longer.difference) / deciding(difference.part)) / std::log(ratio);
    error.measured_from   = longer.step;
    error.failed_in_other = is_before(error.until, shorter.until);
    const auto step = numbers(error.step), half = numbers(error.half_step);
    for (std::size_t q = 0; q < step.size() && !(order < least_order); ++q) // NaN: no third run
      {
        const double found = q < 3 ? std::log(longer.difference[q] / *step[q]) / std::log(ratio)
                                   : MonitorSummary::unknown;
        const double p     = std::isnan(found) ? error.assumed_order
                                               : std::clamp(found, first_order, error.assumed_order);
        *step[q] /= std::pow(ratio, p) - 1.;
        *half[q] = *step[q] * std::pow(0.5, p);
      }
    error.peak_at_end = peaks_at_an_end(shorter, longer, error.step.part[2]);
  }



  void measure_error_by_shorter_steps(const StepRecord       &run,
                                      const StepRecord       &shorter,
                                      Summary::ProbableError &error)
  {
    if (!tells(step_difference(run, shorter), run, shorter, error))
      return;
    error.measured_from   = shorter.step;
    error.failed_in_other = is_before(error.until, run.until);
    const double gain     = std::pow(run.step / shorter.step, error.assumed_order);
    for (double *part : numbers(error.step))
      *part *= gain / (gain - 1.);
    for (double *part : numbers(error.half_step))
      *part /= gain - 1.;
    error.peak_at_end = peaks_at_an_end(run, shorter, error.step.part[2]);
  }
} // namespace hybrid::output
