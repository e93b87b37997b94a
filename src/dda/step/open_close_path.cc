// SPDX-License-Identifier: GPL-3.0-or-later
// The interior point method: all contacts change their conditions together.
#include <hybrid/dda/step/open_close_iteration.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  double OpenCloseIteration::begin_path()
  {
    constexpr double width         = 10.; ///< force over the mean, and parting likewise
    double           stiffness_sum = 0., force = 0.;
    int              n = 0, n_loaded = 0;
    // Joints tell the scale only where there is no contact: they bear more.
    for (int contacts = 1; contacts >= 0 && n == 0; --contacts)
      for (std::size_t k = 0; k < problem.springs.n_at_work(); ++k)
        {
          const Springs::Spring &spring = problem.springs.springs[problem.springs.at_work(k)];
          if (spring.length <= 0. || (contacts == 1 && !spring.coulomb))
            continue;
          const double pressed = spring.length * std::max(0., spring.old.normal);
          stiffness_sum += spring.length * spring.law->normal_stiffness();
          force += pressed * pressed;
          n_loaded += pressed > 0. ? 1 : 0;
          ++n;
        }
    if (n == 0)
      return 0.;
    force = n_loaded > 0 ? std::sqrt(force / n_loaded)
                         : problem.forces() / std::sqrt(std::max(1, problem.model->n_blocks()));
    interior.begin(*problem.model,
                   problem.springs,
                   problem.trial.dt,
                   path_progress.width * width * force * force * n / stiffness_sum,
                   force);
    return interior.mean_product();
  }



  double
  OpenCloseIteration::go_along_path(StepResult &result, const Stride stride, const bool begins)
  {
    constexpr double too_narrow = 0.1, nearly_all = 0.995, least_centring = 1e-6;
    const double     most_centring = stride == Stride::own ? 0.1 : 1.;
    const double     mean          = interior.mean_product();
    interior.aim(0., false);
    interior.set_responses(problem.trial, problem.springs);
    double norm = problem.balance();
    tangent.assemble(problem, {true, true});
    tangent.outdate();
    solve_linear(result, UpdateAccuracy::finest * norm);
    ++result.iterations;
    const double affine = interior.follow(problem.springs, tangent.of_springs(), update);
    if (begins && affine < too_narrow)
      return 0.;
    const double left     = interior.mean_product_after(affine) / mean;
    const double centring = std::max(least_centring, left * left * left);
    interior.aim(std::min(most_centring, centring) * mean, affine > too_narrow);
    interior.set_responses(problem.trial, problem.springs);
    norm = problem.balance();
    solve_linear(result, UpdateAccuracy::finest * norm);
    const double part =
      std::min(1., nearly_all * interior.follow(problem.springs, tangent.of_springs(), update));
    if (stride == Stride::own)
      interior.move_each(nearly_all);
    else
      interior.move(part);
    problem.move(update, stride == Stride::own ? 1. : part);
    result.residual = problem.evaluate();
    path_progress.saw(part, result.residual, interior.mean_product());
    return part;
  }



  Attempt OpenCloseIteration::follow_path(StepResult &result, const Stride stride)
  {
    problem.evaluate_alone();
    result.residual       = problem.go_back(problem.is_narrow() ? local.start : at_start);
    is_on_path            = !problem.is_narrow();
    const Attempt attempt = go_to_end_of_path(result, stride);
    is_on_path            = false;
    return attempt;
  }



  Attempt OpenCloseIteration::go_to_end_of_path(StepResult &result, const Stride stride)
  {
    constexpr double   few_changes = 0.01, near_balance = 1e-2, wider = 100.;
    constexpr int      most_widenings = 4;
    constexpr Patience to_finish{12, 1};
    path_progress = {};
    if (begin_path() <= 0.)
      return Attempt::failed;
    path_now.assign(conditions.size(), Condition::law);
    path_tried.clear();
    bool begins = true;
    for (int widenings = 0; may_go_on(result);)
      {
        if (go_along_path(result, stride, begins && widenings < most_widenings) == 0. && begins)
          {
            path_progress.width *= wider;
            ++widenings;
            result.residual = problem.evaluate();
            begin_path();
            continue;
          }
        begins = false;
        if (!std::isfinite(result.residual) || path_progress.holds())
          return Attempt::failed;
        if (is_balanced(result))
          return Attempt::converged;
        const int changed = interior.conditions(path_now);
        if (changed <= few_changes * interior.size() && result.residual <= near_balance &&
            path_now != path_tried)
          {
            problem.keep(on_path);
            conditions.assign(path_now.begin(), path_now.end());
            path_tried.assign(path_now.begin(), path_now.end());
            const Attempt attempt = iterate_conditions(result, to_finish);
            if (attempt != Attempt::failed)
              return attempt;
            result.residual = problem.go_back(on_path);
          }
      }
    return result.stopped ? Attempt::stopped : Attempt::failed;
  }
} // namespace hybrid::dda
