// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/heartbeat.h>
#include <hybrid/output/progress.h>
#include <hybrid/output/terminal.h>

#include <chrono>

namespace hybrid::output
{
  Heartbeat::Heartbeat(std::ostream &stream,
                       const bool    stream_is_terminal,
                       std::string   what,
                       const double  interval)
    : out(stream)
    , is_terminal(stream_is_terminal)
    , text(std::move(what))
    , thread([this, interval]() {
      beat(interval > 0. ? interval : is_terminal ? 1. : 60.);
    })
  {}



  Heartbeat::~Heartbeat()
  {
    {
      const std::lock_guard<std::mutex> lock(guard);
      is_over = true;
    }
    over.notify_all();
    thread.join();
    if (is_terminal && is_drawn)
      out << "\r\033[K" << std::flush;
  }



  void Heartbeat::beat(const double interval)
  {
    const double                 begin = steady_seconds();
    std::unique_lock<std::mutex> lock(guard);
    while (
      !over.wait_for(lock, std::chrono::duration<double>(interval), [this]() { return is_over; }))
      {
        const std::string line = text + ": " + format_duration(steady_seconds() - begin);
        is_drawn               = true;
        if (is_terminal)
          out << "\r\033[K" << fitting_line({line}, "", terminal_width() - 1) << std::flush;
        else
          out << line << std::endl;
      }
  }
} // namespace hybrid::output
