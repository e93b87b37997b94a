// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/coupling/coupled_step.h>
#include <hybrid/coupling/rigid_foundation.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::coupling;

  /// Constant acceleration of 2 m/s2 for one second.
  scene::GroundMotion uniformly_accelerated(const scene::MotionParameters &parameters = {})
  {
    return {scene::Motion(0.5, {2., 2., 2.}), parameters};
  }
} // namespace



TEST(RigidFoundation, follows_the_motion_from_its_start_time)
{
  scene::MotionParameters parameters;
  parameters.angle = std::atan2(0.8, 0.6) * 180. / M_PI;
  parameters.start = 0.25;
  RigidFoundation base({Vec2(0., 0.), Vec2(5., 1.)}, uniformly_accelerated(parameters));
  CoupledState    state;
  const dda::FoundationResponse &early = base.predict(state, 0.2);
  EXPECT_TRUE(early.prescribed);
  EXPECT_EQ(early.displacement.norm(), 0.);

  state.time                = 0.7;
  const Eigen::VectorXd now = base.predict(state, 0.05).displacement;
  const double          u   = 0.5 * 2. * 0.5 * 0.5; // half a second after the start
  ASSERT_EQ(now.size(), 4);
  for (int k = 0; k < 2; ++k)
    {
      EXPECT_NEAR(now[2 * k], 0.6 * u, 1e-14);
      EXPECT_NEAR(now[2 * k + 1], 0.8 * u, 1e-14);
    }
}



TEST(RigidFoundation, changes_no_state)
{
  RigidFoundation       base({Vec2(0., 0.)}, uniformly_accelerated());
  CoupledState          state;
  const Eigen::VectorXd once = base.predict(state, 0.1).displacement;
  EXPECT_EQ(state.time, 0.);
  EXPECT_EQ(base.predict(state, 0.1).displacement, once);
  base.correct(state, 0.1, once, once);
  EXPECT_EQ(state.time, 0.);
  EXPECT_TRUE(state.continuum.displacement.empty());
}



TEST(RigidFoundation, without_a_motion_stays)
{
  RigidFoundation base({Vec2(0., 0.), Vec2(1., 0.)}, {});
  CoupledState    state;
  state.time = 3.;
  EXPECT_EQ(base.predict(state, 0.1).displacement, Eigen::VectorXd(Eigen::VectorXd::Zero(4)));
}



TEST(RigidFoundation, may_have_no_surface)
{
  RigidFoundation base({}, uniformly_accelerated());
  EXPECT_EQ(base.predict({}, 0.1).displacement.size(), 0);
}



// A block that sticks to the base goes where the base goes.
TEST(RigidFoundation, carries_a_block)
{
  scene::SceneParameters scene = test::block_parameters(60.);
  dda::Model             model =
    dda::build_model(test::square_blocks(1, 1), scene, test::straight_foundation(0., 2., 3.));
  CoupledState state;
  state.blocks = dda::initial_state(model);
  dda::BlockSolver solver(model);
  // One cycle of acceleration, 0.5 m/s2: comes to rest displaced by A T^2 / (2 pi).
  const double        period = 1., amplitude = 0.5;
  std::vector<double> a;
  for (int i = 0; i <= 1000; ++i)
    a.push_back(amplitude * std::sin(2. * M_PI * i * 1e-3 / period));
  RigidFoundation base(model.initial.foundation_nodes, {scene::Motion(1e-3, a), scene.motion});
  CoupledStep     step(&solver, &base, nullptr);
  const double    start = state.blocks.blocks[0].centroid.x();
  for (int k = 0; k < 1500; ++k)
    ASSERT_TRUE(step.solve(state, 1e-3).converged);
  const double moved = amplitude * period * period / (2. * M_PI);
  EXPECT_NEAR(state.blocks.foundation_displacement[0], moved, 1e-5);
  EXPECT_NEAR(state.blocks.blocks[0].centroid.x() - start, moved, 1e-3 * moved);
  EXPECT_NEAR(state.time, 1.5, 1e-12);
}
