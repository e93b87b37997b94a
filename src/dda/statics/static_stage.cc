// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/begin_motion.h>
#include <hybrid/dda/statics/elastic_settlement.h>
#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/dda/step/block_energy.h>
#include <hybrid/dda/step/start_accelerations.h>

#include <algorithm>
#include <cmath>

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



    /// Find the block that has come to rest farther from where it was drawn than half its size
    /// beyond what elasticity explains, or turned by ten degrees; and the loose one that has moved
    /// farthest of those that slid, by a five-hundredth of their size beyond it. (A bonded mass
    /// bends, which the bound does not know, and its joints tell their slip.)
    void find_fallen(const Model                   &model,
                     const std::vector<BlockState> &start,
                     const DdaState                &state,
                     StaticResult                  &result)
    {
      constexpr double turn = 10. * M_PI / 180., slip = 2e-3, clearly = 2.;
      const bool       is_loose =
        !model.blocks_yield && std::none_of(model.bonded.begin(),
                                            model.bonded.begin() + model.n_mass(),
                                            [](const bool bonded) { return bonded; });
      const std::vector<double> elastic = elastic_settlement(model, state);
      for (int b = 0; b < model.n_mass(); ++b)
        {
          const double size           = model.blocks[b].size;
          const double moved          = (state.blocks[b].centroid - start[b].centroid).norm();
          const double turned         = std::abs(state.blocks[b].rotation - start[b].rotation);
          result.largest_displacement = std::max(result.largest_displacement, moved);
          if (is_loose && result.equilibrium && moved > clearly * elastic[b] + slip * size &&
              (result.slid_block < 0 || moved > result.slid_by))
            {
              result.slid_block         = b;
              result.slid_by            = moved;
              result.elastic_settlement = elastic[b];
            }
          if ((moved <= 0.5 * size + elastic[b] && turned <= turn) ||
              (result.fallen_block >= 0 && moved <= result.fallen_by))
            continue;
          result.fallen_block = b;
          result.fallen_by    = moved;
          result.turned_by    = turned;
        }
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
      for (BlockState &block : state.blocks)
        block.rest_plastic_strain = block.plastic_strain;
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

    begin_motion(model, state, {held, false});
    find_fallen(model, start, state, result);
    state.time                 = start_time;
    state.static_force         = state.foundation_force;
    state.static_contact_force = state.foundation_contact_force;
    state.energy               = stored_energy(model, state);
    return result;
  }
} // namespace hybrid::dda
