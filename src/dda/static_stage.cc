// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block_energy.h>
#include <hybrid/dda/start_accelerations.h>
#include <hybrid/dda/static_stage.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    /// The mass on a bedrock that does not move, with unlimited strengths if it is @p held, or with
    /// strengths that slip does not lower.
    Model stage_problem(const Model &model, const bool held, const bool keeps_strengths)
    {
      Model problem        = static_problem(held ? with_unlimited_strengths(model) : model);
      problem.hold_bedrock = true;
      if (!held && keeps_strengths)
        for (Joint &joint : problem.joints)
          joint.law = joint.law.without_softening();
      return problem;
    }



    /// Slip and softening of joints that hold count from now on.
    void reset_softening(DdaState &state)
    {
      for (JointState &joint : state.joints)
        for (const int end : {0, 1})
          {
            joint.rest_slip[end] = joint.points[end].slip;
            if (joint.failure == FailureKind::none)
              joint.points[end].history.softening = 0.;
          }
    }
  } // namespace



  StaticResult settle(const Model       &model,
                      DdaState          &state,
                      const bool         held,
                      const StaticWatch &watch,
                      const bool         resets_softening)
  {
    const double start_time = state.time;
    const auto   start      = state.blocks;
    StaticResult result =
      take_static_steps(stage_problem(model, held, resets_softening), state, {}, watch);
    if (result.stopped)
      return result;
    if (resets_softening)
      reset_softening(state);

    begin_motion(model, state, held);
    for (std::size_t b = 0; b < state.blocks.size(); ++b)
      result.largest_displacement = std::max(result.largest_displacement,
                                             (state.blocks[b].centroid - start[b].centroid).norm());
    state.time                 = start_time;
    state.static_force         = state.base_force;
    state.static_contact_force = state.base_contact_force;
    state.energy               = held_energy(model, state);
    return result;
  }
} // namespace hybrid::dda
