// SPDX-License-Identifier: GPL-3.0-or-later
// How contacts find their conditions: active sets, then the interior point method.
#include <hybrid/dda/springs/spring_condition.h>
#include <hybrid/dda/step/open_close_iteration.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  void OpenCloseIteration::keep(TrialPlace &place) const
  {
    place.increment.assign(trial.increment.begin(), trial.increment.end());
    place.foundation = trial.foundation;
  }



  void OpenCloseIteration::go_back(const Step &step, const TrialPlace &place)
  {
    for (const int b : islands.at_work())
      trial.increment[b] = place.increment[b];
    trial.foundation     = place.foundation;
    step.result.residual = evaluate(step.model, step.state, step.foundation);
  }



  Attempt OpenCloseIteration::settle_contacts(const Step &step)
  {
    constexpr Patience patience{10, 3};
    constexpr int      longest_span                = 16;
    const auto &[model, state, foundation, result] = step;
    const double      first                        = result.residual;
    const std::size_t n                            = springs.springs.size();
    keep(at_start);
    conditions.resize(n);
    if (model.iteration.is_patient)
      return yield_patiently(step);
    local.is_stuck          = false;
    const bool path_at_once = memory.path_steps > 0;
    Attempt    attempt      = Attempt::failed;
    if (path_at_once)
      --memory.path_steps;
    else
      {
        for (std::size_t s = 0; s < n; ++s)
          conditions[s] = condition_of(springs.springs[s].old);
        attempt = iterate_conditions(step, patience);
        if (attempt == Attempt::converged)
          memory = {};
      }
    const bool sets_have_served = memory.path_span == 0;
    if (attempt == Attempt::failed && sets_have_served && local.is_stuck &&
        local.stuck_at != state.time)
      {
        attempt        = Attempt::stuck;
        local.stuck_at = state.time;
      }
    if (attempt != Attempt::failed)
      return attempt;
    attempt = follow_path(step, Stride::own);
    if (attempt == Attempt::converged && !path_at_once)
      memory.path_steps = memory.path_span =
        std::min(std::max(2, 2 * memory.path_span), longest_span);
    if (attempt == Attempt::failed && !(result.residual <= first))
      go_back(step, at_start);
    return attempt;
  }



  Attempt OpenCloseIteration::yield_patiently(const Step &step)
  {
    // Many joints begin to slide, one after the other, and only then the residual falls. The line
    // search goes on where this ends, if that is closer to balance.
    constexpr Patience most{24, 24};
    const double       first = step.result.residual;
    for (std::size_t s = 0; s < conditions.size(); ++s)
      conditions[s] = springs.condition(s);
    const Attempt attempt = iterate_conditions(step, most);
    if (attempt == Attempt::failed && !(step.result.residual < first))
      go_back(step, at_start);
    return attempt;
  }



  Attempt OpenCloseIteration::iterate_conditions(const Step &step, const Patience &patience)
  {
    constexpr double leads_away = 100., well_done = 1e-3, near_balance = 0.1;
    const auto &[model, state, foundation, result] = step;
    const double first                             = result.residual;
    double       least = std::numeric_limits<double>::infinity(), previous = least;
    int          slow      = 0;
    bool         was_local = local.is_on, goes_round = false;
    Circles      circles;
    for (int k = 0; k < patience.updates; ++k)
      {
        if (!may_go_on(step))
          return result.stopped ? Attempt::stopped : Attempt::failed;
        double norm = result.residual;
        if (springs.prescribe(model, state, trial, conditions))
          norm = balance(model, state, foundation);
        const bool served    = !was_local && (k > 0 ? result.residual <= well_done * previous
                                                    : conditions == tangent_conditions);
        const bool is_second = k == 1 && served && conditions == tangent_conditions;
        if (is_second)
          secant.first(update);
        else if (k > 0)
          secant.reset();
        repair(step, served, previous);
        tangent_conditions.resize(conditions.size());
        std::copy(conditions.begin(), conditions.end(), tangent_conditions.begin());
        previous = result.residual;
        // A mass that may rest is balanced block by block, so that it comes to rest.
        const double enough = 0.2 * model.iteration.tolerance;
        const double part   = local.is_on ? LocalAttempt::accuracy : accuracy.part(k);
        solve_linear(step,
                     may_rest ? std::min(enough, 1e-3 * norm) : std::max(enough, part * norm));
        if (k == 0 && !local.is_on)
          secant.correct(scale, update);
        else if (is_second)
          secant.second(update);
        take(step, 1.);
        ++result.iterations;
        result.residual      = evaluate(model, state, foundation);
        const bool converged = is_balanced(step);
        if (!local.is_on)
          accuracy.saw(k, converged ? 0. : result.residual / norm);
        if (converged)
          return Attempt::converged;
        settle_islands(step);
        slow += result.residual > 0.5 * least ? 1 : 0;
        if (!(result.residual <= leads_away * std::max(first, 1.))) // or NaN
          return Attempt::failed;
        if (circles.close(previous, result.residual) || slow > patience.slow_ones)
          {
            if (goes_round || result.residual > near_balance)
              return Attempt::failed;
            goes_round = true;
            slow       = 0;
            circles    = {};
          }
        least = std::min(least, result.residual);
        renew_conditions(goes_round);
        was_local = local.is_on || (result.residual > well_done * previous && settle_few(step));
        if (is_balanced(step))
          return Attempt::converged;
      }
    return Attempt::failed;
  }



  void OpenCloseIteration::settle_islands(const Step &step)
  {
    constexpr double part = 0.05; ///< of the tolerance: what flies keeps what it is left with
    if (!step.foundation.prescribed || step.model.n_bedrock > 0 || local.is_on)
      return;
    if (islands.settle({residual, scale, absolute}, part * step.model.iteration.tolerance, springs))
      interior.leave_settled(springs);
  }



  void OpenCloseIteration::renew_conditions(const bool goes_round)
  {
    const auto slides = [](const Condition c) {
      return c == Condition::slides_forward || c == Condition::slides_backward;
    };
    for (std::size_t k = 0; k < springs.n_at_work(); ++k)
      {
        const std::size_t s   = springs.at_work(k);
        const Condition   now = springs.condition(s), last = conditions[s];
        const bool        slides_back = slides(last) && slides(now) && now != last;
        const bool        to_and_fro =
          (last == Condition::open && slides(now)) || (slides(last) && now == Condition::open);
        conditions[s] = slides_back || (goes_round && to_and_fro) ? Condition::sticks : now;
      }
  }
} // namespace hybrid::dda
