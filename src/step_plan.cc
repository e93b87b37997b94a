// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/processes.h>
#include <hybrid/step_plan.h>

#include <algorithm>
#include <cmath>

namespace hybrid
{
  std::vector<StepLevel> step_plan(const std::vector<double> &ends, const double time_step)
  {
    std::vector<StepLevel> plan;
    double                 begin = 0.;
    int                    last  = 0;
    for (const double end : ends)
      {
        const auto halvings =
          std::max(static_cast<int>(std::lround(std::log2(time_step / (end - begin)))), 0);
        if (halvings != last)
          plan.push_back({begin, halvings});
        last  = halvings;
        begin = end;
      }
    return plan;
  }



  std::vector<StepLevel> from_first(std::vector<StepLevel> plan, const Processes &processes)
  {
    plan.resize(static_cast<std::size_t>(processes.from_first(static_cast<double>(plan.size()))));
    for (StepLevel &level : plan)
      {
        level.from     = processes.from_first(level.from);
        level.halvings = static_cast<int>(processes.from_first(level.halvings));
      }
    return plan;
  }
} // namespace hybrid
