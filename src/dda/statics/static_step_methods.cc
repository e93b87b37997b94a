// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/static_step_methods.h>

#include <algorithm>
#include <utility>

namespace hybrid::dda
{
  namespace
  {
    constexpr double great_step         = 1.;  ///< in which inertia hardly counts [s]
    constexpr int    iterations_on_path = 100; ///< at least, before a step is cut



    /// No joint holds a block of the sliding mass.
    bool is_loose(const Model &model, const DdaState &state)
    {
      if (model.n_mass() == 0)
        return false;
      for (std::size_t j = 0; j < model.joints.size(); ++j)
        if (!model.joints[j].within_bedrock() && state.joints[j].failure == FailureKind::none)
          return false;
      return true;
    }
  } // namespace



  StaticStepMethods::StaticStepMethods(const Model              &static_problem,
                                       OpenCloseIteration::Watch watch_step)
    : problem(static_problem)
    , watch(std::move(watch_step))
  {
    plain.emplace(static_problem);
    plain->set_watch(watch);
  }



  StepResult
  StaticStepMethods::solve(DdaState &state, const FoundationResponse &foundation, const double dt)
  {
    if (method == Method::line_search)
      return plain->solve(state, foundation, dt);
    if (method == Method::on_path)
      return path->solve(state, foundation, dt);
    const StepResult held = from_hold->hold(state, foundation, dt);
    if (held.stopped)
      return held;
    StepResult step = from_hold->solve(state, foundation, dt);
    step.iterations += held.iterations;
    return step;
  }



  void StaticStepMethods::accept(DdaState &state)
  {
    if (method == Method::from_hold)
      from_hold->accept(state);
    else
      (method == Method::on_path ? *path : *plain).accept(state);
  }



  double StaticStepMethods::step_failed(const DdaState &state, const double dt, const bool hopeless)
  {
    if (method == Method::line_search && hopeless && is_loose(problem, state))
      {
        method = Method::from_hold;
        times += plain->part_times();
        plain.reset();
        from_hold.emplace(problem, watch);
        return great_step;
      }
    if (method == Method::from_hold)
      {
        times += from_hold->part_times();
        from_hold.reset();
        go_on_path();
        return first_step;
      }
    if (method == Method::line_search && !problem.blocks_yield && !is_loose(problem, state))
      {
        times += plain->part_times();
        plain.reset();
        in_bonds = true;
        go_on_path();
      }
    return dt / 4.;
  }



  void StaticStepMethods::go_on_path()
  {
    method                               = Method::on_path;
    together                             = problem;
    together->iteration.changes_together = true;
    together->iteration.few_settle_alone = true;
    together->iteration.maximum_iterations =
      std::max(iterations_on_path, problem.iteration.maximum_iterations);
    path.emplace(*together);
    path->set_watch(watch);
  }



  bool StaticStepMethods::leads_nowhere(const double unbalanced)
  {
    constexpr int    many = 8;
    constexpr double fall = 0.98, flies = 0.4; // all of it falls freely at 0.5
    if (method != Method::on_path || unbalanced > flies || in_bonds)
      return false;
    vain  = unbalanced > fall * least ? vain + 1 : 0;
    least = std::min(least, unbalanced);
    return vain == many;
  }



  PartTimes StaticStepMethods::part_times() const
  {
    PartTimes all = times;
    if (plain)
      all += plain->part_times();
    if (from_hold)
      all += from_hold->part_times();
    if (path)
      all += path->part_times();
    return all;
  }
} // namespace hybrid::dda
