// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/statics/static_steps.h>
#include <hybrid/dda/step/initial_state.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// Loose squares of stiff rock in columns beside each other on a slope.
  Model stiff_columns(const int columns, const int rows, const double degrees)
  {
    const double angle = degrees * M_PI / 180.;
    return static_problem(build_model(square_blocks(columns, rows, 1., angle),
                                      block_parameters(25., 50e9),
                                      straight_foundation(angle, 10., 20.)));
  }



  /// A column of loose squares on a slope that it stands on, damped when it moves.
  Model column(const double friction_angle)
  {
    const double           angle = 20. * M_PI / 180.;
    scene::SceneParameters p     = block_parameters(friction_angle);
    p.blocks.damping_ratio       = 0.05;
    return build_model(square_blocks(1, 2, 1., angle), p, straight_foundation(angle, 5., 5.));
  }
} // namespace



TEST(StaticSteps, the_problem_has_neither_damping_nor_edge_loads)
{
  Model model                = column(30.);
  model.bedrock_damping_time = 0.1;
  model.dynamic_coefficient  = 0.9;
  model.edge_loads.edges.resize(1);
  const Model problem = static_problem(model);
  EXPECT_GT(model.joint_damping_time, 0.);
  EXPECT_EQ(problem.joint_damping_time, 0.);
  EXPECT_EQ(problem.bedrock_damping_time, 0.);
  EXPECT_EQ(problem.dynamic_coefficient, 1.);
  EXPECT_TRUE(problem.edge_loads.edges.empty());
  for (int b = 0; b < model.n_blocks(); ++b)
    {
      EXPECT_GT(model.blocks[b].damping_time, 0.);
      EXPECT_EQ(problem.blocks[b].damping_time, 0.);
    }
}



TEST(StaticSteps, rest_does_not_depend_on_the_pace)
{
  const Model model = static_problem(column(30.));
  DdaState    slow = initial_state(model), fast = slow;
  const auto  slowly  = take_static_steps(model, slow, {1.5, 400});
  const auto  quickly = take_static_steps(model, fast, {4., 400});
  ASSERT_TRUE(slowly.equilibrium);
  ASSERT_TRUE(quickly.equilibrium);
  EXPECT_LE(quickly.residual, 1e-9);
  EXPECT_LT(quickly.steps, slowly.steps);
  for (int b = 0; b < model.n_blocks(); ++b)
    {
      EXPECT_LT((slow.blocks[b].centroid - fast.blocks[b].centroid).norm(), 1e-7); // m
      EXPECT_EQ(fast.blocks[b].velocity.norm(), 0.);
      EXPECT_EQ(fast.blocks[b].acceleration.norm(), 0.);
    }
}



TEST(StaticSteps, a_wall_with_hundreds_of_contacts_at_their_limit_comes_to_rest)
{
  // Blocks that spread under their weight slide on one another and on the ground.
  const int          columns = 8, rows = 25;
  const Model        model = static_problem(build_model(square_blocks(columns, rows),
                                                 block_parameters(31., 5e9),
                                                 straight_foundation(0., 10., 10.)));
  DdaState           state = initial_state(model);
  const StaticResult r     = take_static_steps(model, state);
  ASSERT_TRUE(r.equilibrium);
  EXPECT_GE(r.cuts, 1); // else it is no case for what is tested
  EXPECT_LE(r.iterations,
            150); // 60; 285 with all steps to the end, 2016 without SlidingRegularisation
  double weight = 0., borne = 0.;
  for (const BlockProperties &block : model.blocks)
    weight += block.weight * model.gravity;
  for (int k = 0; k < model.n_foundation_nodes(); ++k)
    borne -= state.foundation_force[2 * k + 1];
  EXPECT_NEAR(borne, weight, 1e-6 * weight);
  // Symmetric, and settled as much as bars of that weight, between free and confined ones.
  const int    left = (rows - 1) * columns + columns / 2 - 1;
  const Vec2   top  = 0.5 * (state.blocks[left].centroid + state.blocks[left + 1].centroid);
  const double bar  = 0.5 * 2220. * 9.81 * rows * rows / 5e9;
  EXPECT_NEAR(top.x(), 0.5 * columns, 1e-9);
  EXPECT_GT(rows - 0.5 - top.y(), 0.8 * bar);
  EXPECT_LT(rows - 0.5 - top.y(), 1.2 * bar);
}



TEST(StaticSteps, columns_that_lean_on_each_other_come_to_rest_in_few_steps)
{
  const Model        model = stiff_columns(20, 20, 2.);
  DdaState           state = initial_state(model);
  const StaticResult r     = take_static_steps(model, state);
  ASSERT_TRUE(r.equilibrium);
  EXPECT_LE(r.iterations, 150); // 104; 408 in 13 steps without the interior point method
  EXPECT_LE(r.steps, 6);
  double weight = 0.;
  Vec2   borne  = Vec2::Zero();
  for (const BlockProperties &block : model.blocks)
    weight += block.weight * model.gravity;
  for (int k = 0; k < model.n_foundation_nodes(); ++k)
    borne -= state.foundation_force.segment<2>(2 * k);
  EXPECT_NEAR(borne.x(), 0., 1e-6 * weight);
  EXPECT_NEAR(borne.y(), weight, 1e-6 * weight);
}



TEST(StaticSteps, columns_that_topple_are_given_up_before_they_lie)
{
  const Model        model = stiff_columns(10, 10, 10.); // stands up to atan(1/10) = 5.7 degrees
  DdaState           state = initial_state(model);
  const StaticResult r     = take_static_steps(model, state);
  EXPECT_FALSE(r.equilibrium);
  EXPECT_GT(r.residual, 1e-4);
  EXPECT_LE(r.steps, 20); // 10; 400 without the interior point method
  EXPECT_GE(r.moving_block, 0);
}



TEST(StaticSteps, what_is_drawn_above_the_ground_falls_and_lies_on_it)
{
  const int          columns = 6, rows = 4;
  const double       drop  = 0.2;
  const Model        model = static_problem(build_model(square_blocks(columns, rows),
                                                 block_parameters(31., 5e9),
                                                 {{-10., -drop}, {20., -drop}}));
  DdaState           state = initial_state(model);
  const StaticResult r     = take_static_steps(model, state);
  ASSERT_TRUE(r.equilibrium);
  for (int b = 0; b < model.n_blocks(); ++b)
    EXPECT_NEAR(state.blocks[b].centroid.y(), b / columns + 0.5 - drop, 1e-3); // m
}



TEST(StaticSteps, what_cannot_stand_is_given_up_after_the_last_step)
{
  const Model        model = static_problem(column(15.));
  DdaState           state = initial_state(model);
  const StaticResult r     = take_static_steps(model, state, {2., 7});
  EXPECT_FALSE(r.equilibrium);
  EXPECT_EQ(r.steps, 7);
  EXPECT_GT(r.residual, 1e-9);
  EXPECT_GE(r.moving_block, 0);
}
