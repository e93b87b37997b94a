// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/probable_error.h>
#include <hybrid/scene/motion/filter.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr double      rows_per_period = 8.; ///< of the corner
    constexpr std::size_t most_rows       = 1 << 16;
    constexpr double      at_rest         = 1e-9; ///< round-off moves by as much [m/s]
    constexpr double      unseen = 1e-6;      ///< of the largest velocity: a component has no error
    constexpr double      highest_turn = 1.5; ///< w dt that a step is asked about [-]
    constexpr double      fades_from   = 0.5; ///< of the highest frequency [-]
    /// Of the sum of what scheme and late damping make: that they cancel at some step says nothing
    /// of all that is left out. With 0.5 Badong's velocity leaves the factor of 3 [-].
    constexpr double least_of_both = 0.3;
    /// Of (w dt)^2, with a corrected inertia: dashpots and incoming waves [-].
    constexpr double of_displacement = 1. / 8., of_velocity = 1. / 12.;
    /// Of (w dt)^2: tanh(x) is x (1 + (w dt)^2 of it), x = i w dt/2 [-].
    constexpr double of_mean_rate = 1. / 12.;



    /// More of a monitor's energy than the first part in the last part of the record: its motion
    /// has hardly begun [-].
    constexpr double most_late = 0.9, late = 0.2;

    /// Of the peak velocity, at the end of the record: more of what is no answer is a wave that has
    /// just come [-].
    constexpr double most_left_at_end = 0.05;



    /// Linear between the times of a record.
    class Interpolation
    {
    public:
      Interpolation(const std::vector<double> &record_time, const std::vector<double> &record_pairs)
        : time(record_time)
        , pairs(record_pairs)
      {}

      /// Later than the time asked before.
      double at(const double t, const int component)
      {
        while (row + 2 < time.size() && time[row + 1] <= t)
          ++row;
        const double weight = std::min((t - time[row]) / (time[row + 1] - time[row]), 1.);
        return (1. - weight) * pairs[2 * row + component] +
               weight * pairs[2 * (row + 1) + component];
      }

    private:
      const std::vector<double> &time, &pairs;
      std::size_t                row = 0;
    };



    std::vector<double> rates(const std::vector<double> &x, const double spacing)
    {
      std::vector<double> result(x.size(), 0.);
      for (std::size_t i = 1; i + 1 < x.size(); ++i)
        result[i] = (x[i + 1] - x[i - 1]) / (2. * spacing);
      return result;
    }



    std::vector<double> second_rates(const std::vector<double> &x, const double spacing)
    {
      std::vector<double> result(x.size(), 0.);
      for (std::size_t i = 1; i + 1 < x.size(); ++i)
        result[i] = (x[i + 1] - 2. * x[i] + x[i - 1]) / (spacing * spacing);
      return result;
    }



    /// In the record and for as long after it.
    std::vector<double>
    source_velocity(const ErrorRecord &record, const double spacing, const std::size_t rows)
    {
      std::vector<double> result(2 * rows, 0.);
      if (record.source)
        for (std::size_t i = 0; i < result.size(); ++i)
          result[i] = (record.source(record.time[0] + (i + 1) * spacing) -
                       record.source(record.time[0] + i * spacing)) /
                      spacing;
      return result;
    }



    /// Times that tell how the model answers: those before it breaks, if something shakes it.
    std::vector<double> times_of(const ErrorRecord &record)
    {
      std::vector<double> result = record.time;
      while (record.source && result.size() > 2 && result.back() > record.until) // NaN: never
        result.pop_back();
      return result;
    }
  } // namespace



  double ProbableError::make_spacing(const std::vector<double> &time, const double corner)
  {
    assert(time.size() > 1);
    const double duration = time.back() - time.front();
    const double step     = duration / (time.size() - 1);
    double       rows     = 1.; // steps per row
    if (corner > 0.)
      rows = std::max(1., std::floor(1. / (rows_per_period * corner * step)));
    return std::max(rows * step, duration / most_rows);
  }



  ProbableError::ProbableError(const ErrorRecord &record)
    : time(times_of(record))
    , corner(record.corner)
    , least_motion(record.least_motion)
    , spacing(make_spacing(time, corner))
    , rows(static_cast<std::size_t>(std::floor((time.back() - time.front()) / spacing + 1e-6)))
    , rows_until(rows)
    , base(record.base)
    , base_is_prescribed(record.base_is_prescribed)
    , response(spacing, source_velocity(record, spacing, rows))
  {
    if (std::isfinite(record.until))
      rows_until = static_cast<std::size_t>(
        std::clamp((record.until - time.front()) / spacing, 0., double(rows)));
    for (const ErrorRecord::Monitor &monitor : record.monitors)
      add(monitor);
    find_peaks();
    find_delays();
  }



  void ProbableError::add(const ErrorRecord::Monitor &monitor)
  {
    Motion motion;
    motion.name    = monitor.name;
    motion.in_rock = monitor.in_rock;
    motion.is_led  = monitor.is_led;
    for (int c = 0; c < 2; ++c)
      {
        Interpolation position(time, *monitor.displacement);
        double        last = position.at(time[0], c);
        for (std::size_t i = 0; i < rows; ++i)
          {
            const double next = position.at(time[0] + (i + 1) * spacing, c);
            motion.velocity[c].push_back((next - last) / spacing);
            motion.relative[c].push_back(0.5 * (last + next));
            last = next;
          }
      }
    motions.push_back(std::move(motion));
  }



  void ProbableError::find_peaks()
  {
    if (base >= 0)
      {
        const Motion ground = motions[base];
        for (Motion &motion : motions)
          for (int c = 0; c < 2; ++c)
            for (std::size_t i = 0; i < rows; ++i)
              motion.relative[c][i] -= ground.relative[c][i];
      }
    for (Motion &motion : motions)
      {
        History a[2];
        for (int c = 0; c < 2; ++c)
          {
            motion.relative[c] = filtered(motion.relative[c]);
            a[c]               = filtered(rates(motion.velocity[c], spacing));
          }
        motion.peak[0] = largest_size(motion.relative[0], motion.relative[1]);
        motion.peak[1] = largest_size(filtered(motion.velocity[0]), filtered(motion.velocity[1]));
        motion.peak[2] = largest_size(a[0], a[1]);
        for (int q = 0; q < 3; ++q)
          largest[q] = std::max(largest[q], motion.peak[q]);
      }
  }



  void ProbableError::find_delays()
  {
    for (Motion &motion : motions)
      for (int c = 0; c < 2; ++c)
        {
          double most = 0.;
          for (const double v : motion.velocity[c])
            most = std::max(most, std::abs(v));
          motion.delay[c] =
            most > unseen * largest[1]
              ? response.delay(motion.velocity[c])
              : ResponseDelay::Delay{ResponseDelay::Spectrum(response.frequencies().size(), 0.)};
        }
  }



  ProbableError::History ProbableError::filtered(const History &history) const
  {
    return history.size() < 2 ? history : scene::low_pass(history, spacing, corner);
  }



  double ProbableError::largest_size(const History &x, const History &y) const
  {
    double result = 0.;
    for (std::size_t i = 0; i < rows_until; ++i)
      result = std::max(result, std::hypot(x[i], y[i]));
    return result;
  }



  bool ProbableError::counts(const std::size_t m, const int quantity) const
  {
    return !(quantity == 0 && int(m) == base) && !(quantity == 2 && motions[m].is_led) &&
           motions[m].peak[quantity] > least_motion * largest[quantity];
  }



  std::string ProbableError::hardly_begun() const
  {
    for (std::size_t m = 0; largest[1] > at_rest && m < motions.size(); ++m)
      {
        if (!counts(m, 0) && !counts(m, 1) && !counts(m, 2))
          continue;
        const History *velocity = motions[m].velocity;
        double         all = 0., early = 0.;
        for (std::size_t i = 0; i < rows_until; ++i)
          {
            const double energy = velocity[0][i] * velocity[0][i] + velocity[1][i] * velocity[1][i];
            all += energy;
            if (i + 1 <= (1. - late) * rows_until) // all of the row
              early += energy;
          }
        if (all - early > most_late * all)
          return motions[m].name;
      }
    return "";
  }



  std::string ProbableError::reached_at_end() const
  {
    for (std::size_t m = 0; largest[1] > at_rest && m < motions.size(); ++m)
      {
        const ResponseDelay::Delay *delay = motions[m].delay;
        if ((counts(m, 0) || counts(m, 1) || counts(m, 2)) &&
            std::hypot(delay[0].left_at_end, delay[1].left_at_end) >
              most_left_at_end * motions[m].peak[1])
          return motions[m].name;
      }
    return "";
  }



  std::array<ProbableError::History, 3>
  ProbableError::changes(const Motion                  &motion,
                         const int                      c,
                         const ResponseDelay::Spectrum &frequency) const
  {
    std::array<History, 3> error;
    error[1] = response.change(motion.delay[c].spectrum, frequency);
    error[0] = error[1];
    const auto of_base =
      base >= 0 ? response.change(motions[base].delay[c].spectrum, frequency) : History(rows, 0.);
    double sum = 0.; // of what is before the middle of a row
    for (std::size_t i = 0; i < rows; ++i)
      {
        const double added = spacing * (error[1][i] - of_base[i]);
        error[0][i]        = sum + 0.5 * added;
        sum += added;
      }
    return error;
  }



  void ProbableError::add_amplitude(const Motion           &motion,
                                    const int               c,
                                    const double            dt,
                                    std::array<History, 3> &error) const
  {
    const History u = second_rates(motion.relative[c], spacing),
                  v = second_rates(motion.velocity[c], spacing);
    for (std::size_t i = 0; i < rows; ++i)
      {
        error[0][i] += of_displacement * dt * dt * u[i];
        error[1][i] += of_velocity * dt * dt * v[i];
      }
  }



  void ProbableError::add_rates(const Motion           &motion,
                                const int               c,
                                const StepScheme       &scheme,
                                std::array<History, 3> &error) const
  {
    const double  dt = scheme.dt, filter = scheme.newmark.filter;
    const double  first  = scheme.newmark.gamma - 0.5 - filter; // of w dt; 0 with a filter
    const double  second = first * first - 2. * filter - of_mean_rate;
    const History jerk = second_rates(motion.velocity[c], spacing), snap = rates(jerk, spacing);
    error[2] = rates(error[1], spacing);
    for (std::size_t i = 2; i + 2 < rows; ++i) // at the ends derivatives are not known
      {
        error[1][i] -= of_mean_rate * dt * dt * jerk[i];
        error[2][i] += (second - of_mean_rate) * dt * dt * snap[i] - first * dt * jerk[i];
      }
  }



  Summary::ErrorPart ProbableError::evaluate(const FrequencyError &of_frequency,
                                             const double          highest,
                                             const StepScheme     *amplitudes,
                                             const bool            only_rock) const
  {
    ResponseDelay::Spectrum frequency;
    for (const std::complex<double> &s : response.frequencies())
      {
        const double fading = std::clamp((1. - s.imag() / highest) / (1. - fades_from), 0., 1.);
        frequency.push_back(fading > 0. ? fading * of_frequency(s) : 0.);
      }
    Summary::ErrorPart result;
    if (!(largest[1] > at_rest))
      return result;
    for (std::size_t m = 0; m < motions.size(); ++m)
      {
        if (only_rock && !motions[m].in_rock)
          continue;
        std::array<History, 3> errors[2];
        for (int c = 0; c < 2; ++c)
          {
            errors[c] = changes(motions[m], c, frequency);
            if (amplitudes != nullptr && amplitudes->newmark.corrected_step > 0.)
              add_amplitude(motions[m], c, amplitudes->dt, errors[c]);
            if (amplitudes != nullptr && leads(motions[m], *amplitudes))
              add_rates(motions[m], c, *amplitudes, errors[c]);
            else
              errors[c][2] = rates(errors[c][1], spacing);
          }
        for (int q = 0; q < 3; ++q)
          {
            if (!counts(m, q))
              continue;
            const double part =
              largest_size(filtered(errors[0][q]), filtered(errors[1][q])) / motions[m].peak[q];
            if (!(part <= result.part[q])) // NaN: none yet
              {
                result.part[q]  = part;
                result.where[q] = motions[m].name;
              }
          }
      }
    return result;
  }



  Summary::ErrorPart ProbableError::in_rock(const FrequencyError &error, const double highest) const
  {
    return evaluate(error, highest, nullptr, true);
  }



  Summary::ErrorPart ProbableError::of_steps(const StepScheme &scheme) const
  {
    StepScheme undamped   = scheme;
    undamped.late_damping = 0.;
    const auto of_scheme  = [&](const std::complex<double> s) {
      return frequency_error(undamped, s);
    };
    const auto of_all = [&](const std::complex<double> s) { return frequency_error(scheme, s); };
    const auto of_damping = [&](const std::complex<double> s) { return of_all(s) - of_scheme(s); };
    const auto part       = [&](const FrequencyError &error, const StepScheme *amplitudes) {
      return evaluate(error, highest_turn / scheme.dt, amplitudes, false);
    };
    Summary::ErrorPart result = part(of_all, &scheme);
    if (scheme.late_damping > 0.)
      {
        const Summary::ErrorPart parts[] = {part(of_scheme, &scheme), part(of_damping, nullptr)};
        for (int q = 0; q < 3; ++q)
          result.part[q] =
            std::max(result.part[q], least_of_both * (parts[0].part[q] + parts[1].part[q]));
      }
    return result;
  }
} // namespace hybrid::output
