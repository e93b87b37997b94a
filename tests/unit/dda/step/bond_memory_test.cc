// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace hybrid;
using namespace hybrid::dda;
using namespace hybrid::test;

namespace
{
  Vec2 momentum(const FixedBaseRun &run)
  {
    Vec2 sum = Vec2::Zero();
    for (std::size_t b = 0; b < run.state.blocks.size(); ++b)
      sum += run.model.blocks[b].mass * run.state.blocks[b].velocity.head<2>();
    return sum;
  }
} // namespace



TEST(BondMemory, bonded_bodies_that_turn_and_are_hit_keep_their_momentum)
{
  scene::SceneParameters scene             = block_parameters(20., 5e9);
  scene.materials["rock"].cohesion         = 1e9;
  scene.materials["rock"].tensile_strength = 1e9;
  scene.time.newmark                       = Newmark::preset("filtered");
  scene.blocks.bonded                      = true;
  std::vector<Vec2> base                   = straight_foundation(0., 200., 200.);
  for (Vec2 &node : base)
    node.y() -= 100.;
  FixedBaseRun run(row_and_square(2), scene, base);
  run.model.gravity               = 0.;
  run.state                       = initial_state(run.model);
  run.state.blocks[2].velocity[0] = -3.;
  run.state.blocks[0].velocity[2] = run.state.blocks[1].velocity[2] = 2.;
  run.state.blocks[0].velocity[1]                                   = -1.;
  run.state.blocks[1].velocity[1]                                   = 1.;
  const Vec2 before                                                 = momentum(run);
  ASSERT_TRUE(run.run(0.2, 1e-3));
  EXPECT_GT(run.state.blocks[2].velocity[0], -2.);           // they have hit each other,
  EXPECT_GT(std::abs(run.state.blocks[2].velocity[2]), 0.1); // off their centres
  EXPECT_LT((momentum(run) - before).norm(), 1e-9 * run.model.blocks[0].mass * 3.);
}
