// SPDX-License-Identifier: GPL-3.0-or-later
// Few bodies find their conditions by themselves.
#include <hybrid/dda/step/open_close_iteration.h>

#include <algorithm>

namespace hybrid::dda
{
  bool OpenCloseIteration::settle_few(StepResult &result)
  {
    constexpr int most_times = 10;
    if (!problem.model->iteration.few_settle_alone)
      return false;
    int times_moved = 0;
    while (times_moved < most_times && !tangent.is_outdated() && !is_balanced(result) &&
           settle_few_once(result))
      ++times_moved;
    return times_moved > 0;
  }



  bool OpenCloseIteration::settle_few_once(StepResult &result)
  {
    constexpr double   aim = 0.1, gain = 0.8, jump = 30.;
    constexpr Patience patience{6, 3};
    const double       before = result.residual;
    if (!local.system.choose(tangent.rows(), problem.left()))
      return false;
    problem.keep(local.start);
    local.conditions.assign(conditions.begin(), conditions.end());
    problem.narrow(local.system);
    StepResult own;
    own.residual       = problem.relative_residual();
    local.tolerance    = aim * own.residual;
    Attempt    attempt = iterate_conditions(own, patience);
    const bool by_path = attempt == Attempt::failed && !is_on_path;
    if (by_path)
      attempt = follow_path(own, Stride::own);
    result.few_iterations += own.iterations;
    local.is_stuck  = by_path && attempt == Attempt::failed;
    result.residual = problem.whole_residual();
    // Conditions that only the path has found are those of another place: all others follow there.
    const double most = by_path && attempt == Attempt::converged ? jump : gain;
    const bool   good = result.residual <= most * before;
    if (good)
      for (std::size_t k = 0; k < problem.springs.n_at_work(); ++k)
        {
          const std::size_t s = problem.springs.at_work(k);
          local.conditions[s] = by_path ? problem.springs.condition(s) : conditions[s];
        }
    else
      {
        problem.go_back(local.start);
        result.residual = problem.whole_residual();
      }
    conditions.assign(local.conditions.begin(), local.conditions.end());
    problem.widen();
    return good;
  }
} // namespace hybrid::dda
