// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/terminal.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace hybrid::output
{
  /**
   * How far the run is: one line that is redrawn on a terminal, as wide as that is at most, a plain
   * line every 10 % or every minute elsewhere. update() is called after every step and returns at
   * once unless it is time to draw.
   */
  class Progress
  {
  public:
    /**
     * @param stream where to draw.
     * @param stream_is_terminal whether a line can be redrawn: standard_output_is_terminal().
     * @param from_time, to_time simulated time of this run [s]; from_time > 0 after a
     * resume.
     * @param clock wall time in seconds from any origin; the steady clock if empty.
     * @param width columns of the terminal; terminal_width() if empty.
     */
    Progress(std::ostream           &stream,
             bool                    stream_is_terminal,
             double                  from_time,
             double                  to_time,
             std::function<double()> clock = {},
             std::function<int()>    width = {});

    /// After a step: simulated time [s]; accepted steps, open-close iterations since this run
    /// began.
    void update(double new_time, long new_steps, long new_iterations);

    /// Draw the last state and leave the line.
    void finish();

  private:
    /// Draw the current state.
    void draw(double now);

    /// "43.2 %", "t = 5.184 of 12 s", "left 1:23", "812 steps/s", "3.1 iterations/step"
    std::vector<std::string> status() const;

    /// The bar and as much of the status as fits; a short bar rather than less of the status.
    std::string line() const;

    std::ostream           &out;
    const bool              is_terminal;
    const double            start_time;
    const double            end_time;
    std::function<double()> wall_clock;
    std::function<int()>    columns;

    double time       = 0.; ///< simulated [s]
    long   steps      = 0;
    long   iterations = 0;

    double drawn_at    = 0.; ///< wall clock [s]
    double drawn_time  = 0.; ///< simulated [s]
    long   drawn_steps = 0;
    double speed       = 0.; ///< simulated over wall time, recent [-]
    double step_rate   = 0.; ///< recent [1/s]
  };


  /// The steady clock, from any origin [s].
  double steady_seconds();

  /// "0:07", "12:30", "3:05:00": whole seconds as minutes or hours.
  std::string format_duration(double seconds);
} // namespace hybrid::output
