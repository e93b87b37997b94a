// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace hybrid;
using namespace hybrid::dda;
using namespace hybrid::test;

namespace
{
  /// About the origin [kg m/s].
  double angular_momentum(const FixedBaseRun &run)
  {
    double sum = 0.;
    for (std::size_t b = 0; b < run.state.blocks.size(); ++b)
      {
        const BlockState &s       = run.state.blocks[b];
        const Vec6        impulse = mass_matrix(run.model.blocks[b], s.rotation) * s.velocity;
        sum += cross(s.centroid, impulse.head<2>()) + impulse[2];
      }
    return sum;
  }
} // namespace



TEST(ContactCouple, blocks_that_hit_each_other_as_they_turn_keep_their_angular_momentum)
{
  for (const double friction : {0., 30.})
    {
      scene::SceneParameters scene = block_parameters(friction, 5e9);
      scene.time.newmark           = Newmark::preset("filtered");
      std::vector<Vec2> base       = straight_foundation(0., 200., 200.);
      for (Vec2 &node : base)
        node.y() -= 100.;
      FixedBaseRun run(row_and_square(1), scene, base);
      run.model.gravity               = 0.;
      run.state                       = initial_state(run.model);
      run.state.blocks[0].velocity[2] = 4.;
      run.state.blocks[1].velocity[0] = -5.;
      const double before             = angular_momentum(run);
      ASSERT_TRUE(run.run(0.1, 1e-3));
      EXPECT_GT(run.state.blocks[1].velocity[0], -4.); // they have hit each other
      // To the strains of the squares; 3e-3 without couples.
      EXPECT_NEAR(angular_momentum(run), before, 1e-6 * std::abs(before));
    }
}
