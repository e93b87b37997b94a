// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/clock.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hybrid
{
  Clock::Clock(const double time_step, const double end_time, const int maximum_halvings)
    : deepest(maximum_halvings)
    , tick(std::ldexp(time_step, -maximum_halvings))
    , end_ticks(static_cast<std::int64_t>(std::ceil(end_time / time_step - 1e-9))
                << maximum_halvings)
  {}



  void Clock::follow(std::vector<StepLevel> plan)
  {
    planned = std::move(plan);
  }



  int Clock::level() const
  {
    const double soon = time() + 0.5 * tick;
    const auto   next =
      std::upper_bound(planned.begin(),
                       planned.end(),
                       soon,
                       [](const double t, const StepLevel &l) { return t < l.from; });
    if (next == planned.begin())
      return halvings;
    int result = std::clamp((next - 1)->halvings, halvings, deepest);
    while (ticks % ticks_of(result) != 0) // a longer step would not end on a multiple of itself
      ++result;
    return result;
  }



  void Clock::accept()
  {
    ticks += step_ticks();
    ++good_steps;
    if (halvings > 0 && good_steps >= growth_delay && ticks % (2 * step_ticks()) == 0)
      {
        --halvings;
        good_steps = 0;
      }
  }



  bool Clock::shorten_step()
  {
    ++n_cuts;
    good_steps    = 0;
    const int now = level();
    if (now == deepest)
      return false;
    halvings = now + 1;
    return true;
  }



  void Clock::serialize(restart::Archive &archive)
  {
    archive(ticks, halvings, good_steps, n_cuts);
  }
} // namespace hybrid
