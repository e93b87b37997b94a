// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/statics/static_stage.h>

#include <functional>
#include <ostream>

namespace hybrid::output
{
  /**
   * How far the static stage is: one line that is redrawn on a terminal, as wide as that is at
   * most, a plain line every minute elsewhere. How long it takes is not known beforehand: told are
   * the steps and iterations done and the residual that has to fall to its target. A stage of less
   * than half a second shows nothing.
   */
  class StaticProgressLine
  {
  public:
    /**
     * @param stream where to draw.
     * @param stream_is_terminal whether a line can be redrawn: standard_output_is_terminal().
     * @param clock wall time in seconds from any origin; the steady clock if empty.
     * @param width columns of the terminal; terminal_width() if empty.
     */
    StaticProgressLine(std::ostream           &stream,
                       bool                    stream_is_terminal,
                       std::function<double()> clock = {},
                       std::function<int()>    width = {});

    /// Before an iteration; returns at once unless it is time to draw.
    void update(const dda::StaticProgress &progress);

  private:
    std::ostream           &out;
    const bool              is_terminal;
    std::function<double()> wall_clock;
    std::function<int()>    columns;
    double                  drawn_at; ///< wall clock [s]
    bool                    is_drawn = false;
  };
} // namespace hybrid::output
