// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/formatted.h>
#include <hybrid/output/progress.h>
#include <hybrid/output/static_progress.h>

namespace hybrid::output
{
  namespace
  {
    constexpr double first_interval  = 0.5; ///< on a terminal, before the first line [s]
    constexpr double redraw_interval = 0.2; ///< on a terminal [s]
    constexpr double line_interval   = 60.; ///< elsewhere [s]


    /// In one line of @p width characters at most.
    std::string in_words(const dda::StaticProgress &progress, const int width)
    {
      std::string text;
      for (const char *form :
           {"Static stage: %d steps, %d iterations, relative residual %.1e (ends at %.0e)",
            "Static stage: %d steps, %d iterations, residual %.1e of %.0e",
            "Static: %d, %d, %.1e of %.0e"})
        {
          text = formatted(
            form, progress.steps, progress.iterations, progress.residual, progress.target);
          if (text.size() <= static_cast<std::size_t>(width))
            return text;
        }
      return fitting_line({text}, "", width);
    }
  } // namespace



  StaticProgressLine::StaticProgressLine(std::ostream           &stream,
                                         const bool              stream_is_terminal,
                                         std::function<double()> clock,
                                         std::function<int()>    width)
    : out(stream)
    , is_terminal(stream_is_terminal)
    , wall_clock(clock ? std::move(clock) : std::function<double()>(steady_seconds))
    , columns(width ? std::move(width) : std::function<int()>(terminal_width))
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
    if (is_terminal)
      out << "\r\033[K" << in_words(progress, columns() - 1) << std::flush;
    else
      out << in_words(progress, 1000) << std::endl;
  }
} // namespace hybrid::output
