// SPDX-License-Identifier: GPL-3.0-or-later
// Light bodies beside heavy ones: each is balanced, not their sum alone.
#include <hybrid/dda/step/open_close_iteration.h>

#include <algorithm>
#include <limits>

namespace hybrid::dda
{
  void OpenCloseIteration::balance_each(StepResult &result)
  {
    constexpr int most_times = 10;
    light.clear();
    StepProblem::Imbalance left = problem.imbalance(light);
    if (left.is_any() && tangent.is_outdated())
      {
        problem.complete();
        tangent.repair(problem, false, true);
      }
    const bool of_laws = tangent_conditions.empty(); // the kept tangent
    for (int k = 0; k < most_times && left.is_any(); ++k)
      if (!balance_light(result, left))
        break;
    if (of_laws)
      tangent_conditions.clear();
  }



  bool OpenCloseIteration::balance_light(StepResult &result, StepProblem::Imbalance &left)
  {
    constexpr double   aim = 0.3, gain = 0.5;
    constexpr Patience patience{10, 3};
    local.system.choose(tangent.rows(), light);
    problem.keep(local.start);
    problem.narrow(local.system);
    conditions.resize(problem.springs.springs.size());
    for (std::size_t s = 0; s < conditions.size(); ++s)
      conditions[s] = problem.springs.condition(s);
    StepResult own;
    own.residual    = problem.relative_residual();
    local.tolerance = aim * left.least_allowed / problem.forces();
    local.enough    = 0.2 * local.tolerance;
    if (iterate_conditions(own, patience) == Attempt::failed && !is_on_path)
      follow_path(own, Stride::own);
    local.enough = std::numeric_limits<double>::infinity();
    result.few_iterations += own.iterations;
    result.residual                  = problem.whole_residual();
    const StepProblem::Imbalance now = problem.imbalance(light);
    const bool                   good =
      now.worst <= gain * left.worst && result.residual <= problem.model->iteration.tolerance;
    if (!good)
      {
        problem.go_back(local.start);
        result.residual = problem.whole_residual();
      }
    problem.widen();
    left = now;
    return good;
  }
} // namespace hybrid::dda
