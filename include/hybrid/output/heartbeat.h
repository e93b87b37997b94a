// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

namespace hybrid::output
{
  /**
   * Tells that work goes on whose progress is not known: while it lives, what is being done and for
   * how long, in one line that is redrawn each second on a terminal and written each minute
   * elsewhere. Work of less than a second shows nothing. Nobody else may write to the stream.
   */
  class Heartbeat
  {
  public:
    /// @param stream_is_terminal whether a line can be redrawn.
    /// @param what is done: "Meshing about 90000 cells".
    /// @param interval [s]; 0: a second on a terminal, a minute elsewhere.
    Heartbeat(std::ostream &stream,
              bool          stream_is_terminal,
              std::string   what,
              double        interval = 0.);

    /// Wipes the line.
    ~Heartbeat();

    Heartbeat(const Heartbeat &)            = delete;
    Heartbeat &operator=(const Heartbeat &) = delete;

  private:
    void beat(double interval);

    std::ostream           &out;
    const bool              is_terminal;
    const std::string       text;
    bool                    is_over  = false;
    bool                    is_drawn = false;
    std::mutex              guard;
    std::condition_variable over;
    std::thread             thread;
  };
} // namespace hybrid::output
