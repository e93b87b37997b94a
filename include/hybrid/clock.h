// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/archive_forward.h>
#include <hybrid/step_plan.h>

#include <cstdint>
#include <vector>

namespace hybrid
{
  /**
   * Simulated time in steps of dt / 2^k.
   *
   * Counts whole ticks of the smallest step, so time does not drift. A step
   * that failed is halved; after a few good steps the clock tries the next
   * longer step again, where it ends on a multiple of itself. Steps may be cut
   * beforehand, as those of another run were.
   */
  class Clock
  {
  public:
    /// @param time_step dt [s].  @param end_time [s].  @param maximum_halvings largest k.
    Clock(double time_step, double end_time, int maximum_halvings);

    /// Steps are to be cut at least so far, by number of halvings. Not in the checkpoint.
    void follow(std::vector<StepLevel> plan);

    /// Time now [s].
    double time() const
    {
      return static_cast<double>(ticks) * tick;
    }

    bool at_end() const
    {
      return ticks >= end_ticks;
    }

    /// The step to try next [s].
    double next_step() const
    {
      return tick * static_cast<double>(step_ticks());
    }

    /// The step was accepted.
    void accept();

    /// The step failed: halve it. @return false if it was the smallest allowed.
    bool shorten_step();

    /// Steps that were halved so far.
    long cuts() const
    {
      return n_cuts;
    }

    /// Where it stands, for the checkpoint; the end time stays that of the constructor.
    void serialize(restart::Archive &archive);

  private:
    static constexpr int growth_delay = 8; ///< good steps before a longer one is tried

    const int    deepest;   ///< largest number of halvings
    const double tick;      ///< smallest step [s]
    std::int64_t end_ticks; ///< rounded to whole steps of dt
    std::int64_t ticks      = 0;
    int          halvings   = 0;
    int          good_steps = 0;
    long         n_cuts     = 0;

    std::vector<StepLevel> planned;

    std::int64_t ticks_of(const int level) const
    {
      return std::int64_t{1} << (deepest - level);
    }

    /// Halvings of the step to try next.
    int level() const;

    std::int64_t step_ticks() const
    {
      return ticks_of(level());
    }
  };
} // namespace hybrid
