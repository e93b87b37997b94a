// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/great_static_steps.h>
#include <hybrid/dda/statics/static_step_parts.h>
#include <hybrid/dda/statics/static_steps.h>
#include <hybrid/dda/statics/stick_predictor_steps.h>
#include <hybrid/dda/step/block_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hybrid::dda
{
  namespace
  {
    constexpr double first_step    = 0.0156; ///< pseudo time step [s]
    constexpr double smallest_step = 1e-5;
    constexpr double largest_step  = 1e3;
    constexpr int    many_cuts     = 4;  ///< of plain steps after the first one
    constexpr double great_step    = 1.; ///< in which inertia hardly counts [s]



    /// True if the forces that are left drive the blocks on the way that they move.
    bool gains_speed(const Model &problem, const DdaState &state)
    {
      double power = 0.;
      for (int b = 0; b < problem.n_blocks(); ++b)
        {
          const BlockState &block = state.blocks[b];
          power +=
            block.velocity.dot(mass_matrix(problem.blocks[b], block.rotation) * block.acceleration);
        }
      return power > 0.;
    }



    /**
     * How static steps of blocks that yield go on. Their plastic zones grow with every step, so
     * that a step that was too long is so again soon; and what fails does so by many short steps.
     */
    class YieldPace
    {
    public:
      void step_failed(const double dt)
      {
        too_long = dt;
        good     = 0;
      }

      /// @param unbalanced relative force that is left after the step
      void step_done(const Model &problem, const DdaState &state, const double unbalanced)
      {
        constexpr double hardly = 0.9; // less than a tenth has been balanced
        keeps                   = unbalanced > hardly * before && gains_speed(problem, state);
        before                  = unbalanced;
        ++good;
      }

      /// The velocities are not set to zero: the blocks move on and gain speed.
      bool keeps_velocity() const
      {
        return keeps;
      }

      /// A step as long as the last one that failed is not yet tried again.
      bool waits(const double dt) const
      {
        constexpr int few = 4;
        return dt >= too_long && good < few;
      }

    private:
      double too_long = std::numeric_limits<double>::infinity(); ///< step that failed last [s]
      double before   = std::numeric_limits<double>::infinity(); ///< unbalanced, a step ago [-]
      int    good     = 0;                                       ///< steps since one has failed
      bool   keeps    = false;
    };



    /// Steps in which contacts change their conditions together, by the interior point method. It
    /// takes more iterations than small masses need, but hardly more for large ones.
    class PathSteps
    {
    public:
      PathSteps(const Model &problem, const OpenCloseIteration::Watch &watch)
        : together(problem)
        , solver(together)
      {
        together.iteration.changes_together   = true;
        together.iteration.maximum_iterations = std::max(100, problem.iteration.maximum_iterations);
        solver.set_watch(watch);
      }

      PathSteps(const PathSteps &)            = delete; // the solver refers to the model
      PathSteps &operator=(const PathSteps &) = delete;

      BlockSolver &steps()
      {
        return solver;
      }

      /// The mass moves on, and the force that drives it does not fall. @param unbalanced relative
      /// force that is left after another step
      bool leads_nowhere(const double unbalanced)
      {
        constexpr int    many = 8;
        constexpr double fall = 0.5;
        vain                  = unbalanced > fall * least ? vain + 1 : 0;
        least                 = std::min(least, unbalanced);
        return vain == many;
      }

    private:
      Model       together;
      BlockSolver solver;
      double      least = std::numeric_limits<double>::infinity(); ///< left after a step [-]
      int         vain  = 0; ///< steps in a row that have not lowered it
    };



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



  Model static_problem(const Model &model)
  {
    Model copy                = model;
    copy.joint_damping_time   = 0.;
    copy.bedrock_damping_time = 0.;
    copy.damps_loose          = false;
    copy.maxwell              = {};
    copy.edge_loads.edges.clear();
    copy.water.history = nullptr; // the level of the start
    for (BlockProperties &block : copy.blocks)
      block.damping_time = block.loose_damping_time = 0.;
    copy.newmark             = Newmark::preset("shi");
    copy.dynamic_coefficient = 1.;
    copy.iteration.tolerance = 0.1 * static_target;
    // Without inertia full steps go anywhere: a column of 50 took 1,629 iterations, not 114.
    copy.iteration.changes_together = false;
    copy.iteration.stops_at_rest    = false; // one update at least: it may find what slides
    return copy;
  }



  Model with_unlimited_friction(Model model)
  {
    for (std::vector<ContactLaw> &laws : model.contacts.of)
      for (ContactLaw &contact : laws)
        contact.law = contact.law.with(JointStrength::unlimited_friction());
    return model;
  }



  Model with_unlimited_bonds(Model model)
  {
    for (Joint &joint : model.joints)
      if (!joint.within_bedrock())
        joint.law = joint.law.with(JointStrength::unlimited_bond());
    for (BlockProperties &block : model.blocks)
      block.strength = {};
    model.blocks_yield = false;
    return model;
  }



  Model with_unlimited_strengths(const Model &model)
  {
    return with_unlimited_friction(with_unlimited_bonds(model));
  }



  StaticResult take_static_steps(const Model       &problem,
                                 DdaState          &state,
                                 const StaticPace  &pace,
                                 const StaticWatch &watch)
  {
    StaticResult result;
    if (!problem.blocks_yield && is_whole(problem, state) &&
        take_great_steps(problem, state, watch, result))
      return result;
    FoundationResponse foundation;
    foundation.displacement = state.foundation_displacement;
    const OpenCloseIteration::Watch watch_step =
      watch ? watch_of_step(watch, result) : OpenCloseIteration::Watch();
    BlockSolver solver(problem);
    solver.set_watch(watch_step);
    // Of loose blocks: once plain steps have not converged, and once these have not either.
    std::optional<StickPredictorSteps> from_hold;
    std::optional<PathSteps>           on_path;

    YieldPace yielding;
    for (double dt = first_step; result.steps < pace.maximum_steps && dt >= smallest_step;)
      {
        if (!yielding.keeps_velocity())
          stop_blocks(state);
        StepResult step;
        BlockSolver &alone      = on_path ? on_path->steps() : solver;
        const bool   holds_first = from_hold && !on_path;
        if (holds_first)
          {
            step = from_hold->hold(state, foundation, dt);
            result.iterations += step.iterations;
          }
        if (!step.stopped)
          {
            step =
              holds_first
                ? from_hold->solve(state, foundation, dt, result.steps > 0 ? result.residual : 1.)
                : alone.solve(state, foundation, dt);
            result.iterations += step.iterations;
          }
        result.stopped = step.stopped;
        if (result.stopped)
          return result;
        if (!step.converged)
          {
            ++result.cuts;
            yielding.step_failed(dt);
            dt /= 4.;
            const bool hopeless = result.steps == 0 || result.cuts >= many_cuts;
            if (holds_first)
              {
                on_path.emplace(problem, watch_step);
                dt = first_step;
              }
            else if (!from_hold && hopeless && is_loose(problem, state))
              {
                from_hold.emplace(problem, watch_step);
                dt = great_step;
              }
            continue;
          }
        state.time = -1. - dt; // failures of these steps get a negative time
        if (holds_first)
          from_hold->accept(state);
        else
          alone.accept(state);
        ++result.steps;
        result.residual     = std::max(step.unbalanced, step.residual);
        result.moving_block = step.largest_block;
        if (result.residual <= static_target)
          {
            result.equilibrium  = true;
            result.moving_block = -1;
            break;
          }
        if (slides_or_shears(problem, state) || (on_path && on_path->leads_nowhere(step.unbalanced)))
          break;
        if (problem.blocks_yield)
          {
            yielding.step_done(problem, state, step.unbalanced);
            if (yielding.waits(pace.growth * dt))
              continue;
          }
        dt = std::min(largest_step, pace.growth * dt);
      }
    stop_blocks(state);
    result.times += solver.part_times();
    if (from_hold)
      result.times += from_hold->part_times();
    if (on_path)
      result.times += on_path->steps().part_times();
    return result;
  }
} // namespace hybrid::dda
