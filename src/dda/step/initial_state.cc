// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/dda/step/block_energy.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/dda/step/start_accelerations.h>

namespace hybrid::dda
{
  DdaState initial_state(const Model &model)
  {
    DdaState state;
    state.geometry = model.initial;
    state.blocks.resize(model.blocks.size());
    const Geometry &g = state.geometry;
    for (int b = 0; b < g.n_blocks(); ++b)
      state.blocks[b].centroid =
        polygon_moments(&g.vertices[g.offset[b]], g.offset[b + 1] - g.offset[b]).centroid;
    if (model.maxwell.is_on())
      state.branch_stress.assign(model.blocks.size() * model.maxwell.n_branches(),
                                 Eigen::Vector3d::Zero());
    state.joints.resize(model.joints.size());
    const Eigen::Index n           = 2 * model.n_foundation_nodes();
    state.foundation_displacement  = Eigen::VectorXd::Zero(n);
    state.foundation_force         = Eigen::VectorXd::Zero(n);
    state.static_force             = Eigen::VectorXd::Zero(n);
    state.static_contact_force     = Eigen::VectorXd::Zero(n);
    state.boundary_force           = Eigen::VectorXd::Zero(2 * BoundaryEdge::n_points *
                                                 static_cast<Eigen::Index>(model.boundary.size()));
    state.foundation_contact_force = Eigen::VectorXd::Zero(n);
    start_accelerations(model, state);
    return state;
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
      state.energy.kinetic = stored_energy(model, state).kinetic;
  }
} // namespace hybrid::dda
