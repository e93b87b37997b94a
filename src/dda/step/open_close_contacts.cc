// SPDX-License-Identifier: GPL-3.0-or-later
// How contacts find their conditions: active sets, then the interior point method.
#include <hybrid/dda/springs/spring_condition.h>
#include <hybrid/dda/step/open_close_iteration.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  Attempt OpenCloseIteration::settle_contacts(StepResult &result)
  {
    constexpr Patience patience{10, 3};
    constexpr int      longest_span = 16;
    const Model       &model        = *problem.model;
    const double       first        = result.residual;
    const std::size_t  n            = problem.springs.springs.size();
    problem.keep(at_start);
    conditions.resize(n);
    if (model.iteration.is_patient)
      return yield_patiently(result);
    local.is_stuck          = false;
    const bool path_at_once = memory.path_steps > 0;
    Attempt    attempt      = Attempt::failed;
    if (path_at_once)
      --memory.path_steps;
    else
      {
        for (std::size_t s = 0; s < n; ++s)
          conditions[s] = condition_of(problem.springs.springs[s].old);
        attempt = iterate_conditions(result, patience);
        if (attempt == Attempt::converged)
          memory = {};
      }
    const bool sets_have_served = memory.path_span == 0;
    if (attempt == Attempt::failed && sets_have_served && local.is_stuck &&
        local.stuck_at != problem.before->time)
      {
        attempt        = Attempt::stuck;
        local.stuck_at = problem.before->time;
      }
    if (attempt != Attempt::failed)
      return attempt;
    attempt = follow_path(result, Stride::own);
    if (attempt == Attempt::converged && !path_at_once)
      memory.path_steps = memory.path_span =
        std::min(std::max(2, 2 * memory.path_span), longest_span);
    if (attempt == Attempt::failed && !(result.residual <= first))
      result.residual = problem.go_back(at_start);
    return attempt;
  }



  Attempt OpenCloseIteration::yield_patiently(StepResult &result)
  {
    // Many joints begin to slide, one after the other, and only then the residual falls. The line
    // search goes on where this ends, if that is closer to balance.
    constexpr Patience most{24, 24};
    const double       first = result.residual;
    problem.complete();
    for (std::size_t s = 0; s < conditions.size(); ++s)
      conditions[s] = problem.springs.condition(s);
    const Attempt attempt = iterate_conditions(result, most);
    if (attempt == Attempt::failed && !(result.residual < first))
      result.residual = problem.go_back(at_start);
    return attempt;
  }



  Attempt OpenCloseIteration::iterate_conditions(StepResult &result, const Patience &patience)
  {
    constexpr double leads_away = 100., well_done = 1e-3, near_balance = 0.1;
    const Model     &model = *problem.model;
    const double     first = result.residual;
    double           least = std::numeric_limits<double>::infinity(), previous = least;
    int              slow = 0;
    WholeBonds       whole{!problem.is_narrow() && !is_on_path};
    bool             was_local = problem.is_narrow(), goes_round = false;
    Circles          circles;
    for (int k = 0; k < patience.updates; ++k)
      {
        if (!may_go_on(result))
          return result.stopped ? Attempt::stopped : Attempt::failed;
        const double norm      = balance_in_conditions(result, whole);
        const bool   served    = !was_local && (k > 0 ? result.residual <= well_done * previous
                                                      : conditions == tangent_conditions);
        const bool   is_second = k == 1 && served && conditions == tangent_conditions;
        if (is_second)
          tangent.secant.first(update);
        else if (k > 0)
          tangent.secant.reset();
        if (!tangent.serves(served))
          problem.complete(&conditions);
        tangent.repair(problem, served, result.residual <= previous);
        tangent_conditions.resize(conditions.size());
        std::copy(conditions.begin(), conditions.end(), tangent_conditions.begin());
        previous = result.residual;
        // A mass that may rest is balanced block by block, so that it comes to rest.
        const double enough = std::min(0.2 * model.iteration.tolerance, local.enough);
        const double part   = problem.is_narrow() ? LocalAttempt::accuracy : accuracy.part(k);
        solve_linear(result,
                     may_rest ? std::min(enough, 1e-3 * norm) : std::max(enough, part * norm));
        if (k == 0 && !problem.is_narrow())
          tangent.secant.correct(problem.left().scale, update);
        else if (is_second)
          tangent.secant.second(update);
        problem.move(update, 1.);
        ++result.iterations;
        result.residual      = problem.evaluate();
        const bool converged = is_balanced(result);
        if (!problem.is_narrow())
          accuracy.saw(k, converged ? 0. : result.residual / norm);
        if (converged)
          return Attempt::converged;
        slow += !whole.are_held && result.residual > 0.5 * least ? 1 : 0;
        if (!(result.residual <= leads_away * std::max(first, 1.))) // or NaN
          return Attempt::failed;
        if (!whole.are_held &&
            (circles.close(previous, result.residual) || slow > patience.slow_ones))
          {
            if (goes_round || result.residual > near_balance)
              return Attempt::failed;
            goes_round = true;
            slow       = 0;
            circles    = {};
          }
        least = std::min(least, result.residual);
        renew_conditions(goes_round);
        was_local =
          problem.is_narrow() ||
          (!whole.are_held && result.residual > well_done * previous && settle_few(result));
        if (is_balanced(result))
          return Attempt::converged;
      }
    return Attempt::failed;
  }



  double OpenCloseIteration::balance_in_conditions(StepResult &result, WholeBonds &whole)
  {
    constexpr double settled = 0.1; ///< of the largest that was left [-]
    constexpr int    most    = 5;   ///< updates with bonds that hold
    whole.are_held           = whole.may_be && problem.hold_bonds();
    const bool   changes     = problem.prescribe(conditions) || whole.are_held;
    const double norm        = changes ? problem.balance() : result.residual;
    if (!whole.are_held)
      return norm;
    whole.largest = std::max(whole.largest, norm);
    if (whole.updates++ < most && !(norm <= settled * whole.largest))
      return norm;
    whole           = {false};
    result.residual = problem.evaluate();
    problem.keep(at_start);
    return problem.prescribe(conditions) ? problem.balance() : result.residual;
  }



  void OpenCloseIteration::renew_conditions(const bool goes_round)
  {
    const auto slides = [](const Condition c) {
      return c == Condition::slides_forward || c == Condition::slides_backward;
    };
    const auto renewed = [&](const std::size_t s) {
      const Condition now = problem.springs.condition(s), last = conditions[s];
      const bool      slides_back = slides(last) && slides(now) && now != last;
      const bool      to_and_fro =
        (last == Condition::open && slides(now)) || (slides(last) && now == Condition::open);
      return slides_back || (goes_round && to_and_fro) ? Condition::sticks : now;
    };
    if (problem.is_shared())
      {
        const std::vector<int> &own  = problem.share().springs();
        const bool              stay = std::all_of(own.begin(), own.end(), [&](const int s) {
          return renewed(s) == conditions[s];
        });
        if (problem.share().all(stay))
          return;
        problem.complete();
      }
    for (std::size_t k = 0; k < problem.springs.n_at_work(); ++k)
      {
        const std::size_t s = problem.springs.at_work(k);
        conditions[s]       = renewed(s);
      }
  }
} // namespace hybrid::dda
