// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block_energy.h>
#include <hybrid/dda/initial_velocities.h>
#include <hybrid/dda/model.h>
#include <hybrid/dda/polygon.h>
#include <hybrid/dda/state.h>
#include <hybrid/scene/input_error.h>

#include <string>

namespace hybrid::dda
{
  std::vector<MovingBlocks>
  find_moving_blocks(const std::vector<scene::InitialVelocity> &parameters,
                     const Geometry                            &geometry,
                     const int                                  n_mass)
  {
    std::vector<MovingBlocks> result;
    std::vector<int>          taken(n_mass, -1); // by a box
    for (std::size_t k = 0; k < parameters.size(); ++k)
      {
        const scene::InitialVelocity &given = parameters[k];
        MovingBlocks                  moving{{}, given.velocity, given.spin};
        for (int b = 0; b < n_mass; ++b)
          {
            const int  first = geometry.offset[b];
            const Vec2 x =
              polygon_moments(&geometry.vertices[first], geometry.offset[b + 1] - first).centroid;
            if (!((x.array() >= given.lower.array()).all() &&
                  (x.array() <= given.upper.array()).all()))
              continue;
            if (taken[b] >= 0)
              throw InputError("Blocks/Initial velocities: the block at (" + std::to_string(x.x()) +
                               ", " + std::to_string(x.y()) + ") m lies in the boxes of '" +
                               parameters[taken[b]].name + "' and '" + given.name + "'");
            taken[b] = static_cast<int>(k);
            moving.blocks.push_back(b);
          }
        if (moving.blocks.empty())
          throw InputError("Blocks/Initial velocities: no block has its centroid in the box of '" +
                           given.name + "'");
        result.push_back(std::move(moving));
      }
    return result;
  }



  void set_in_motion(const Model &model, DdaState &state)
  {
    for (const MovingBlocks &moving : model.moving_blocks)
      {
        double mass   = 0.;
        Vec2   centre = Vec2::Zero();
        for (const int b : moving.blocks)
          {
            mass += model.blocks[b].mass;
            centre += model.blocks[b].mass * state.blocks[b].centroid;
          }
        centre /= mass;
        for (const int b : moving.blocks)
          {
            const Vec2 arm           = state.blocks[b].centroid - centre;
            state.blocks[b].velocity = Vec6::Zero();
            state.blocks[b].velocity.head<2>() =
              moving.velocity + moving.spin * Vec2(-arm.y(), arm.x());
            state.blocks[b].velocity[2] = moving.spin;
          }
      }
    if (!model.moving_blocks.empty())
      state.energy.kinetic = held_energy(model, state).kinetic;
  }
} // namespace hybrid::dda
