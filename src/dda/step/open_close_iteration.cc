// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/open_close_iteration.h>
#include <hybrid/restart/archive.h>

namespace hybrid::dda
{
  StepResult OpenCloseIteration::solve(const Model              &model,
                                       const DdaState           &state,
                                       const FoundationResponse &foundation,
                                       const double              dt,
                                       const std::vector<Vec6>  *guess)
  {
    StepResult result;
    may_rest = at_rest = false;
    interior.clear();
    tangent.begin(model, foundation);
    problem.surface = &tangent.surface();
    problem.begin(model, state, foundation, dt);
    if (guess != nullptr)
      problem.trial.increment = *guess;
    if (problem.flies_too_far(result))
      return result;
    result.residual       = guess == nullptr ? problem.choose_start() : problem.evaluate();
    result.first_residual = result.residual;
    may_rest              = guess == nullptr && problem.moves_nothing();
    at_rest               = may_rest && problem.lies_in_balance();
    Attempt attempt       = Attempt::converged;
    if (at_rest)
      memory = {};
    else
      attempt = iterate(result);
    constexpr int few_iterations = 4;
    expects_many                 = result.iterations > few_iterations;
    result.converged             = attempt == Attempt::converged;
    if (!result.converged)
      return result;
    problem.finish(at_rest);
    problem.judge(result);
    result.converged = result.displacement_ratio <= model.iteration.maximum_displacement_ratio;
    return result;
  }



  Attempt OpenCloseIteration::iterate(StepResult &result)
  {
    const IterationParameters &parameters = problem.model->iteration;
    tangent.connect(problem);
    Attempt attempt = parameters.changes_together ? settle_contacts(result) : Attempt::failed;
    if (attempt == Attempt::failed)
      attempt = search(result);
    if (attempt == Attempt::failed && parameters.changes_together && !parameters.is_patient)
      attempt = follow_path(result, Stride::common);
    if (attempt == Attempt::converged)
      balance_each(result);
    return attempt;
  }



  bool OpenCloseIteration::may_go_on(StepResult &result) const
  {
    if (result.iterations >= problem.model->iteration.maximum_iterations)
      return false;
    result.stopped = watch && !watch(result);
    return !result.stopped;
  }



  bool OpenCloseIteration::is_balanced(const StepResult &result) const
  {
    return result.residual <=
           (problem.is_narrow() ? local.tolerance : problem.model->iteration.tolerance);
  }



  void OpenCloseIteration::solve_linear(StepResult &result, const double tolerance)
  {
    if (problem.is_narrow())
      tangent.solve_few(problem, local.system, tolerance, update);
    else
      tangent.solve(problem, tolerance, update, result);
  }



  void OpenCloseIteration::serialize(restart::Archive &archive)
  {
    PartTimes times = part_times();
    tangent.serialize(archive);
    archive(expects_many, memory.path_steps, memory.path_span, tangent_conditions, accuracy.left);
    archive(times);
    if (!archive.is_reading())
      return;
    problem.times = times;
    tangent.times = {};
  }
} // namespace hybrid::dda
