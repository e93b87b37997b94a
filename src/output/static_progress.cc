// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/progress.h>
#include <hybrid/output/static_progress.h>

#include <cstdio>

namespace hybrid::output
{
  namespace
  {
    constexpr double first_interval  = 0.5; ///< on a terminal, before the first line [s]
    constexpr double redraw_interval = 0.2; ///< on a terminal [s]
    constexpr double line_interval   = 60.; ///< elsewhere [s]
  }                                         // namespace



  StaticProgressLine::StaticProgressLine(std::ostream           &stream,
                                         const bool              stream_is_terminal,
                                         std::function<double()> clock)
    : out(stream)
    , is_terminal(stream_is_terminal)
    , wall_clock(clock ? std::move(clock) : std::function<double()>(steady_seconds))
    , drawn_at(wall_clock())
  {}



  void StaticProgressLine::update(const dda::StaticProgress &progress)
  {
    const double now      = wall_clock();
    const double interval = !is_terminal ? line_interval
                            : is_drawn   ? redraw_interval
                                         : first_interval;
    if (now - drawn_at < interval)
      return;
    drawn_at = now;
    is_drawn = true;
    char text[160];
    std::snprintf(text,
                  sizeof(text),
                  "Static stage: %d steps, %d iterations, relative residual %.1e (ends at %.0e)",
                  progress.steps,
                  progress.iterations,
                  progress.residual,
                  progress.target);
    if (is_terminal)
      out << "\r\033[K" << text << std::flush;
    else
      out << text << std::endl;
  }
} // namespace hybrid::output
