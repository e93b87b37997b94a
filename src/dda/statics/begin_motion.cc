// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/springs/surface_force.h>
#include <hybrid/dda/statics/begin_motion.h>
#include <hybrid/dda/statics/static_steps.h>
#include <hybrid/dda/step/rest_forces.h>
#include <hybrid/dda/step/start_accelerations.h>

#include <utility>

namespace hybrid::dda
{
  namespace
  {
    /// The model that held the parts.
    Model holding(const Model &model, const HeldParts &held)
    {
      Model result = held.mass ? with_unlimited_strengths(model) : model;
      return held.planes ? with_unlimited_planes(std::move(result)) : result;
    }
  } // namespace



  void begin_motion(const Model &model, DdaState &state, const HeldParts &held)
  {
    {
      const Model holder = holding(model, held);
      if (model.n_bedrock > 0)
        {
          const RestForces springs(holder, state);
          const int        first = 6 * model.n_mass(), n = 6 * model.n_bedrock;
          state.bedrock_static_force =
            springs.bonds.segment(first, n) + springs.contacts.segment(first, n);
        }
      state.surface_force = surface_force(model, springs_at_rest(holder, state));
    }
    Model bonds = held.mass ? with_unlimited_bonds(model) : model;
    if (held.planes)
      bonds = with_unlimited_planes(std::move(bonds));
    start_accelerations(bonds, state);
  }



  void store_static_reactions(const Model &model, DdaState &state, const HeldParts &held)
  {
    const RestForces springs(holding(model, held), state);
    const int        first = 6 * model.n_blocks(), n = 2 * model.n_foundation_nodes();
    state.foundation_contact_force = springs.contacts.segment(first, n);
    state.foundation_force     = springs.bonds.segment(first, n) + state.foundation_contact_force;
    state.static_force         = state.foundation_force;
    state.static_contact_force = state.foundation_contact_force;
    begin_motion(model, state, held);
  }
} // namespace hybrid::dda
