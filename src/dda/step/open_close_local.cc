// SPDX-License-Identifier: GPL-3.0-or-later
// Few bodies find their conditions by themselves.
#include <hybrid/dda/step/open_close_iteration.h>

#include <algorithm>

namespace hybrid::dda
{
  bool OpenCloseIteration::settle_few(const Step &step)
  {
    constexpr int most_times = 10;
    if (!step.model.iteration.few_settle_alone || step.model.n_bedrock > 0)
      return false;
    int times_moved = 0;
    while (times_moved < most_times && !stale && !is_balanced(step) && settle_few_once(step))
      ++times_moved;
    return times_moved > 0;
  }



  bool OpenCloseIteration::settle_few_once(const Step &step)
  {
    constexpr double   aim = 0.1, gain = 0.8, jump = 30.;
    constexpr Patience patience{6, 3};
    const auto &[model, state, foundation, result] = step;
    const double before                            = result.residual;
    if (!local.system.choose(matrix, {residual, scale}))
      return false;
    keep(local.start);
    local.conditions.assign(conditions.begin(), conditions.end());
    islands.narrow(local.system.changing_blocks());
    springs.narrow(local.system.blocks(), local.system.nodes());
    local.is_on = true;
    StepResult own;
    own.residual    = relative_residual();
    local.tolerance = aim * own.residual;
    const Step few{model, state, foundation, own};
    Attempt    attempt = iterate_conditions(few, patience);
    const bool by_path = attempt == Attempt::failed && !is_on_path;
    if (by_path)
      attempt = follow_path(few, Stride::own);
    result.few_iterations += own.iterations;
    local.is_stuck  = by_path && attempt == Attempt::failed;
    local.is_on     = false;
    result.residual = relative_residual();
    // Conditions that only the path has found are those of another place: all others follow there.
    const double most = by_path && attempt == Attempt::converged ? jump : gain;
    const bool   good = result.residual <= most * before;
    if (good)
      for (std::size_t k = 0; k < springs.n_at_work(); ++k)
        {
          const std::size_t s = springs.at_work(k);
          local.conditions[s] = by_path ? springs.condition(s) : conditions[s];
        }
    else
      go_back(step, local.start);
    conditions.assign(local.conditions.begin(), local.conditions.end());
    islands.widen();
    springs.widen();
    return good;
  }
} // namespace hybrid::dda
