// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/great_static_steps.h>
#include <hybrid/dda/statics/static_step_parts.h>
#include <hybrid/dda/step/block_solver.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace hybrid::dda
{
  namespace
  {
    constexpr double first_great_step    = 16.; ///< pseudo time step [s]
    constexpr double smallest_great_step = 1.;
    constexpr double great_growth        = 8.;
    constexpr int    max_great_steps     = 10;
    /// Residual that the last step may begin with [-]: the geometry that it began with then differs
    /// from that at its end by less than forces may.
    constexpr double small_start = 1e-7;
    /// Of the first step [-], far from rest. What slips in it stays, so that it must not hang on
    /// where the iteration was left (doc/notes/solver.md).
    constexpr double first_tolerance = 1e-8;



    Model great_problem(const Model &problem)
    {
      Model copy                                = problem;
      copy.iteration.changes_together           = IterationParameters().changes_together;
      copy.iteration.is_patient                 = true;
      copy.iteration.maximum_displacement_ratio = std::numeric_limits<double>::infinity();
      for (Joint &joint : copy.joints) // trials far from rest would tear them
        joint.law = joint.law.without_tensile_failure();
      return copy;
    }
  } // namespace



  std::vector<char> held_to_ground(const Model &model, const std::vector<char> &present)
  {
    const int                     ground = model.n_blocks();
    std::vector<std::vector<int>> held_to(ground + 1);
    for (const Joint &joint : model.joints)
      {
        if (joint.within_bedrock())
          continue;
        const bool on_ground = joint.other == foundation_body || model.is_bedrock(joint.other);
        const int  other     = on_ground ? ground : joint.other;
        held_to[joint.block].push_back(other);
        held_to[other].push_back(joint.block);
      }
    std::vector<char> reached(ground + 1, 0);
    std::vector<int>  next{ground};
    reached[ground] = 1;
    while (!next.empty())
      {
        const int body = next.back();
        next.pop_back();
        for (const int other : held_to[body])
          if ((other == ground || present[other]) && !std::exchange(reached[other], 1))
            next.push_back(other);
      }
    reached.resize(model.n_mass());
    return reached;
  }



  bool is_whole(const Model &model, const DdaState &state)
  {
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      if (!model.joints[j].within_bedrock() && state.joints[j].failure != FailureKind::none)
        return false;
    const std::vector<char> held = held_to_ground(model, std::vector<char>(model.n_mass(), 1));
    return model.n_mass() > 0 &&
           std::all_of(held.begin(), held.end(), [](const char h) { return h != 0; });
  }



  bool take_great_steps(const Model       &problem,
                        DdaState          &state,
                        const StaticWatch &watch,
                        StaticResult      &result)
  {
    Model              great = great_problem(problem);
    const DdaState     start = state;
    const StaticResult none  = result;
    BlockSolver        solver(great);
    great.iteration.tolerance = first_tolerance;
    if (watch)
      solver.set_watch(watch_of_step(watch, result));
    FoundationResponse foundation;
    foundation.displacement = state.foundation_displacement;
    for (double dt = first_great_step; dt >= smallest_great_step && result.steps < max_great_steps;)
      {
        stop_blocks(state);
        const StepResult step = solver.solve(state, foundation, dt);
        result.iterations += step.iterations;
        result.stopped = step.stopped;
        result.times   = solver.part_times();
        if (result.stopped)
          return true;
        if (!step.converged)
          {
            ++result.cuts;
            dt /= 4.;
            continue;
          }
        state.time = -1. - dt;
        solver.accept(state);
        great.joints              = problem.joints; // near rest bonds may tear
        great.iteration.tolerance = problem.iteration.tolerance;
        ++result.steps;
        result.residual    = std::max(step.unbalanced, step.residual);
        result.equilibrium = result.residual <= static_target && step.first_residual <= small_start;
        if (slides_or_shears(great, state) || !is_whole(great, state))
          break;
        if (result.equilibrium)
          {
            stop_blocks(state);
            return true;
          }
        result.residual = std::max(result.residual, step.first_residual); // no more is left
        dt              = std::min(1e3, great_growth * dt);
      }
    const StaticResult spent = std::exchange(result, none);
    result.iterations        = spent.iterations;
    result.times             = spent.times;
    state                    = start;
    return false;
  }
} // namespace hybrid::dda
