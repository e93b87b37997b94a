// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace hybrid
{
  /// Adds the wall time of a scope to a sum [s]. It reads a clock twice (some 50 ns): for scopes of
  /// microseconds and more. Nothing but times may follow from it: results never do.
  class Stopwatch
  {
  public:
    explicit Stopwatch(double &seconds)
      : sum(seconds)
      , start(std::chrono::steady_clock::now())
    {}

    ~Stopwatch()
    {
      sum += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    Stopwatch(const Stopwatch &)            = delete;
    Stopwatch &operator=(const Stopwatch &) = delete;

  private:
    double                                     &sum;
    const std::chrono::steady_clock::time_point start;
  };
} // namespace hybrid
