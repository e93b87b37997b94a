// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/dda/statics/great_static_steps.h>
#include <hybrid/dda/statics/lost_hold.h>
#include <hybrid/dda/statics/static_step_methods.h>
#include <hybrid/dda/statics/static_step_parts.h>
#include <hybrid/dda/statics/static_steps.h>
#include <hybrid/dda/step/block_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybrid::dda
{
  namespace
  {
    constexpr double smallest_step = 1e-5;
    constexpr double largest_step  = 1e3;
    constexpr int    many_cuts     = 4; ///< of plain steps after the first one



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
     * How static steps go on of blocks that yield and of bonds that slide one after the other.
     * Plastic zones grow with every step, so that a step that was too long is so again soon; and
     * blocks that fail do so by many short steps.
     */
    class PlasticPace
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
        keeps = problem.blocks_yield && unbalanced > hardly * before && gains_speed(problem, state);
        before = unbalanced;
        ++good;
      }

      /// The velocities are not set to zero: blocks that yield move on and gain speed.
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



    /// The water's loads on the blocks of the mass where they were drawn.
    std::vector<Vec6> water_as_drawn(const Model &model)
    {
      std::vector<Vec6> loads;
      const Geometry   &g = model.initial;
      for (int b = 0; b < model.n_mass(); ++b)
        {
          const Vec2 *first = &g.vertices[g.offset[b]];
          const int   n     = g.offset[b + 1] - g.offset[b];
          loads.push_back(water_load(model.water,
                                     model.blocks[b].area,
                                     BlockMotion(polygon_moments(first, n).centroid, Vec6::Zero()),
                                     {first, nullptr, n})
                            .force);
        }
      return loads;
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
    if (model.water.action != Water::Action::none && model.water.static_as_drawn)
      {
        copy.dead_loads   = water_as_drawn(model);
        copy.water.action = Water::Action::none;
      }
    for (BlockProperties &block : copy.blocks)
      block.damping_time = block.loose_damping_time = 0.;
    // The steps' sizes say nothing of time, so neither do their rates of slip.
    for (Joint &joint : copy.joints)
      joint.law = joint.law.without_rate_effect();
    for (std::vector<ContactLaw> &laws : copy.contacts.of)
      for (ContactLaw &contact : laws)
        contact.law = contact.law.without_rate_effect();
    copy.newmark             = Newmark::preset("shi");
    copy.dynamic_coefficient = 1.;
    copy.iteration.tolerance = 0.1 * static_target;
    // Without inertia full steps go anywhere: a column of 50 took 1,629 iterations, not 114.
    copy.iteration.changes_together = false;
    copy.iteration.few_settle_alone = false; // but along the central path, see StaticStepMethods
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



  Model with_unlimited_planes(Model model)
  {
    for (Joint &joint : model.joints)
      if (joint.kind == JointKind::bedding)
        joint.law = joint.law.with(JointStrength::unlimited_bond());
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
    StaticStepMethods methods(problem, watch_step);
    PlasticPace       plastic;
    LostHold          hold;
    for (double dt = StaticStepMethods::first_step;
         result.steps < pace.maximum_steps && dt >= smallest_step;)
      {
        if (!plastic.keeps_velocity())
          stop_blocks(state);
        const StepResult step = methods.solve(state, foundation, dt);
        result.iterations += step.iterations;
        result.stopped = step.stopped;
        if (result.stopped)
          return result;
        if (!step.converged)
          {
            ++result.cuts;
            plastic.step_failed(dt);
            const bool hopeless = result.steps == 0 || result.cuts >= many_cuts;
            dt                  = methods.step_failed(state, dt, hopeless);
            continue;
          }
        state.time = -1. - dt; // failures of these steps get a negative time
        methods.accept(state);
        ++result.steps;
        result.residual     = std::max(step.unbalanced, step.residual);
        result.moving_block = step.largest_block;
        if (result.residual <= static_target)
          {
            result.equilibrium  = true;
            result.moving_block = -1;
            break;
          }
        if (hold.falls(problem, state))
          {
            state = hold.loss();
            break;
          }
        if (slides_or_shears(problem, state) || methods.leads_nowhere(step.unbalanced))
          break;
        plastic.step_done(problem, state, step.unbalanced);
        if ((problem.blocks_yield || methods.slides_in_bonds()) && plastic.waits(pace.growth * dt))
          continue;
        dt = std::min(largest_step, pace.growth * dt);
      }
    stop_blocks(state);
    result.times += methods.part_times();
    return result;
  }
} // namespace hybrid::dda
