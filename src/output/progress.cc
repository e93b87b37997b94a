// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/formatted.h>
#include <hybrid/output/progress.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr double  redraw_interval = 0.2; ///< on a terminal [s]
    constexpr double  line_interval   = 60.; ///< elsewhere, at least one line per [s]
    constexpr double  line_fraction   = 0.1; ///< elsewhere, one line per this part of the run [-]
    constexpr double  memory          = 10.; ///< rates are averages over about this wall time [s]
    constexpr int     longest_bar     = 24;  ///< characters
    constexpr int     shortest_bar    = 6;   ///< characters
    const char *const gap             = "  ";
  } // namespace



  Progress::Progress(std::ostream           &stream,
                     const bool              stream_is_terminal,
                     const double            from_time,
                     const double            to_time,
                     std::function<double()> clock,
                     std::function<int()>    width)
    : out(stream)
    , is_terminal(stream_is_terminal)
    , start_time(from_time)
    , end_time(to_time)
    , wall_clock(clock ? std::move(clock) : std::function<double()>(steady_seconds))
    , columns(width ? std::move(width) : std::function<int()>(terminal_width))
    , time(from_time)
    , drawn_at(wall_clock())
    , drawn_time(from_time)
  {}



  void Progress::update(const double new_time, const long new_steps, const long new_iterations)
  {
    time       = new_time;
    steps      = new_steps;
    iterations = new_iterations;

    const double now     = wall_clock();
    const double elapsed = now - drawn_at;
    const bool   is_due =
      is_terminal
          ? elapsed >= redraw_interval
          : elapsed >= line_interval || time - drawn_time >= line_fraction * (end_time - start_time);
    if (is_due)
      draw(now);
  }



  void Progress::draw(const double now)
  {
    const double elapsed = now - drawn_at;
    if (elapsed > 0.)
      {
        const double weight = speed > 0. ? 1. - std::exp(-elapsed / memory) : 1.;
        speed += weight * ((time - drawn_time) / elapsed - speed);
        step_rate += weight * ((steps - drawn_steps) / elapsed - step_rate);
      }
    drawn_at    = now;
    drawn_time  = time;
    drawn_steps = steps;

    if (!is_terminal)
      out << fitting_line(status(), gap, 1000) << std::endl;
    else
      out << "\r\033[K" << line() << std::flush;
  }



  std::string Progress::line() const
  {
    const double fraction =
      end_time > start_time ? (time - start_time) / (end_time - start_time) : 1.;
    const int         width = columns() - 1; // a cursor in the last column begins another line
    const std::string text  = fitting_line(status(), gap, width - shortest_bar - 3);
    const int room   = width - 3 - static_cast<int>(text.size()), // beside "[", "]" and a blank
      length         = std::clamp(room, shortest_bar, longest_bar),
              n_full = std::clamp(static_cast<int>(fraction * length), 0, length);
    return "[" + std::string(n_full, '#') + std::string(length - n_full, '.') + "] " + text;
  }



  std::vector<std::string> Progress::status() const
  {
    const double percent =
      end_time > start_time ? 100. * (time - start_time) / (end_time - start_time) : 100.;
    const std::string        left  = speed > 0. ? format_duration((end_time - time) / speed) : "?";
    std::vector<std::string> parts = {formatted("%5.1f %%", std::clamp(percent, 0., 100.)),
                                      formatted("t = %.3f of %g s", time, end_time),
                                      "left " + left,
                                      formatted("%.3g steps/s", step_rate)};
    if (iterations > 0) // none in waves alone
      parts.push_back(formatted("%.1f iterations/step", static_cast<double>(iterations) / steps));
    return parts;
  }



  void Progress::finish()
  {
    if (is_terminal || steps != drawn_steps)
      draw(wall_clock());
    if (is_terminal)
      out << std::endl;
  }



  double steady_seconds()
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
  }



  std::string format_duration(const double seconds)
  {
    const long total = std::lround(std::clamp(seconds, 0., 3.6e8));
    return total < 3600 ? formatted("%ld:%02ld", total / 60, total % 60)
                        : formatted("%ld:%02ld:%02ld", total / 3600, total / 60 % 60, total % 60);
  }
} // namespace hybrid::output
