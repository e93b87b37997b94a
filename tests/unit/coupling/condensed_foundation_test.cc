// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupled_scenes.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

namespace
{
  using namespace hybrid;

  /// A run in the middle of something, without gravity.
  struct MovingRun : test::CoupledRun
  {
    MovingRun()
      : test::CoupledRun(test::Section(), parameters())
    {
      for (dda::BlockState &block : state.blocks.blocks)
        block.velocity.head<2>() = Vec2(1e-3, -1e-3);
      for (int k = 0; k < 5; ++k)
        EXPECT_TRUE(advance(1e-3));
    }

    static scene::SceneParameters parameters()
    {
      scene::SceneParameters scene = test::coupled_parameters();
      scene.environment.gravity    = 0.;
      return scene;
    }
  };
} // namespace



TEST(CondensedFoundation, surface_is_that_of_the_continuum)
{
  MovingRun run;
  EXPECT_EQ(run.base->surface_nodes(), run.rock.surface_nodes());
  EXPECT_EQ(run.base->surface_nodes().size(), 5u); // two quadratic edges
}



TEST(CondensedFoundation, prediction_changes_no_state)
{
  MovingRun                       run;
  const continuum::ContinuumState before = run.state.continuum;
  const Eigen::VectorXd           load   = run.base->predict(run.state, 1e-3).load;
  EXPECT_EQ(run.state.continuum.time, before.time);
  EXPECT_EQ(run.state.continuum.displacement, before.displacement);
  EXPECT_EQ(run.state.continuum.velocity, before.velocity);
  EXPECT_EQ(run.state.continuum.acceleration, before.acceleration);
  // Another step size in between leaves no trace either.
  run.base->predict(run.state, 5e-4);
  EXPECT_EQ(run.base->predict(run.state, 1e-3).load, load);
}



TEST(CondensedFoundation, response_is_a_symmetric_positive_definite_body)
{
  MovingRun                      run;
  const dda::FoundationResponse &response = run.base->predict(run.state, 1e-3);
  EXPECT_FALSE(response.prescribed);
  const Eigen::MatrixXd s = response.stiffness.dense();
  ASSERT_EQ(s.rows(), 10);
  EXPECT_LT((s - s.transpose()).norm(), 1e-12 * s.norm());
  EXPECT_EQ(s.llt().info(), Eigen::Success);
  EXPECT_EQ(response.displacement.size(), response.load.size());
}



// The accepted surface motion is the solution of S w = g + lambda.
TEST(CondensedFoundation, correction_takes_the_surface_where_the_blocks_found_it)
{
  MovingRun                      run;
  const dda::FoundationResponse &response = run.base->predict(run.state, 1e-3);
  const Eigen::VectorXd          force    = Eigen::VectorXd::LinSpaced(10, -1e3, 1e3);
  const Eigen::VectorXd          w = response.stiffness.dense().ldlt().solve(response.load + force);
  const double                   time = run.state.continuum.time;
  run.base->correct(run.state, 1e-3, w, force);
  EXPECT_DOUBLE_EQ(run.state.continuum.time, time + 1e-3);
  for (std::size_t k = 0; k < run.rock.surface_nodes().size(); ++k)
    {
      const auto point = run.rock.point(run.rock.surface_nodes()[k]);
      const Vec2 u     = run.rock.sample(run.state.continuum, point).displacement;
      EXPECT_NEAR((u - w.segment<2>(2 * k)).norm(), 0., 1e-12 * w.norm());
    }
}



// Action equals reaction: the momentum that blocks lose the rock's surface receives.
TEST(CondensedFoundation, surface_force_is_what_the_blocks_feel)
{
  MovingRun run;
  for (int k = 0; k < 20; ++k)
    {
      ASSERT_TRUE(run.advance(1e-3));
      Vec2 inertia = Vec2::Zero(), force = Vec2::Zero();
      for (int b = 0; b < run.model.n_blocks(); ++b)
        inertia += run.model.blocks[b].mass * run.state.blocks.blocks[b].acceleration.head<2>();
      for (Eigen::Index i = 0; i < run.state.blocks.foundation_force.size(); i += 2)
        force += run.state.blocks.foundation_force.segment<2>(i);
      EXPECT_LT((inertia + force).norm(), 1e-6 * force.norm());
    }
}
