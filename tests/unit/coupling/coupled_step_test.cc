// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupled_scenes.h"

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  void expect_same(const coupling::CoupledState &one, const coupling::CoupledState &other)
  {
    EXPECT_EQ(one.time, other.time);
    EXPECT_EQ(one.continuum.time, other.continuum.time);
    EXPECT_EQ(one.continuum.displacement, other.continuum.displacement);
    EXPECT_EQ(one.continuum.velocity, other.continuum.velocity);
    EXPECT_EQ(one.continuum.acceleration, other.continuum.acceleration);
    EXPECT_EQ(one.continuum.surface_force, other.continuum.surface_force);
    EXPECT_EQ(one.blocks.time, other.blocks.time);
    EXPECT_EQ(one.blocks.geometry.vertices, other.blocks.geometry.vertices);
    EXPECT_EQ(one.blocks.foundation_displacement, other.blocks.foundation_displacement);
    EXPECT_EQ(one.blocks.foundation_force, other.blocks.foundation_force);
    ASSERT_EQ(one.blocks.blocks.size(), other.blocks.blocks.size());
    for (std::size_t b = 0; b < one.blocks.blocks.size(); ++b)
      {
        EXPECT_EQ(one.blocks.blocks[b].centroid, other.blocks.blocks[b].centroid);
        EXPECT_EQ(one.blocks.blocks[b].velocity, other.blocks.blocks[b].velocity);
        EXPECT_EQ(one.blocks.blocks[b].stress, other.blocks.blocks[b].stress);
      }
    for (std::size_t j = 0; j < one.blocks.joints.size(); ++j)
      for (int end = 0; end < 2; ++end)
        EXPECT_EQ(one.blocks.joints[j].points[end].jump, other.blocks.joints[j].points[end].jump);
    EXPECT_EQ(one.blocks.energy.balance(), other.blocks.energy.balance());
  }



  /// Equal to the tolerance of the open-close iteration: kept tangents may differ.
  void expect_close(const coupling::CoupledState &one, const coupling::CoupledState &other)
  {
    EXPECT_EQ(one.time, other.time);
    double scale = 0., difference = 0.;
    for (std::size_t i = 0; i < one.continuum.velocity.size(); ++i)
      {
        scale = std::max(scale, std::abs(other.continuum.velocity[i]));
        difference =
          std::max(difference, std::abs(one.continuum.velocity[i] - other.continuum.velocity[i]));
      }
    for (std::size_t b = 0; b < one.blocks.blocks.size(); ++b)
      {
        const dda::Vec6 &v = one.blocks.blocks[b].velocity, &w = other.blocks.blocks[b].velocity;
        scale      = std::max(scale, w.head<2>().norm());
        difference = std::max(difference, (v - w).head<2>().norm());
      }
    EXPECT_GT(scale, 0.);
    EXPECT_LT(difference, 1e-6 * scale);
  }



  void throw_blocks(CoupledRun &run, const double speed)
  {
    for (dda::BlockState &block : run.state.blocks.blocks)
      block.velocity.head<2>() = Vec2(speed, -speed);
  }
} // namespace



TEST(CoupledStep, that_does_not_converge_leaves_the_state)
{
  scene::SceneParameters scene    = coupled_parameters();
  scene.blocks.maximum_iterations = 1;
  CoupledRun run(Section(), scene);
  throw_blocks(run, 1.);
  const coupling::CoupledState before = run.state;
  EXPECT_FALSE(run.step->solve(run.state, 1e-3).converged);
  expect_same(run.state, before);
}



TEST(CoupledStep, that_moves_too_far_leaves_the_state_and_a_shorter_one_goes_on)
{
  CoupledRun run(Section(), coupled_parameters());
  throw_blocks(run, 10.);
  const coupling::CoupledState before = run.state;
  const dda::StepResult        result = run.step->solve(run.state, 1e-2);
  EXPECT_FALSE(result.converged);
  EXPECT_GT(result.displacement_ratio, run.scene.time.maximum_displacement_ratio);
  expect_same(run.state, before);

  // The failed trial does not change what follows.
  CoupledRun other(Section(), coupled_parameters());
  throw_blocks(other, 10.);
  ASSERT_TRUE(run.step->solve(run.state, 1e-5).converged);
  ASSERT_TRUE(other.step->solve(other.state, 1e-5).converged);
  expect_close(run.state, other.state);
}



TEST(CoupledStep, roll_back_is_a_copy)
{
  CoupledRun run(Section(), coupled_parameters());
  throw_blocks(run, 1e-3);
  for (int k = 0; k < 3; ++k)
    ASSERT_TRUE(run.advance(1e-3));
  const coupling::CoupledState kept = run.state;
  for (int k = 0; k < 3; ++k)
    ASSERT_TRUE(run.advance(1e-3));
  const coupling::CoupledState once = run.state;
  run.state                         = kept;
  for (int k = 0; k < 3; ++k)
    ASSERT_TRUE(run.advance(1e-3));
  expect_close(run.state, once);
}



TEST(CoupledStep, all_clocks_agree)
{
  CoupledRun run(Section(), coupled_parameters());
  for (int k = 0; k < 10; ++k)
    ASSERT_TRUE(run.advance(1e-3));
  EXPECT_NEAR(run.state.time, 0.01, 1e-15);
  EXPECT_NEAR(run.state.blocks.time, 0.01, 1e-15);
  EXPECT_NEAR(run.state.continuum.time, 0.01, 1e-15);
}



TEST(CoupledStep, without_blocks_is_a_step_of_the_continuum)
{
  scene::SceneParameters scene = coupled_parameters();
  scene.blocks.enabled         = false;
  const std::vector<double> a(20, 1.);
  continuum::Continuum      rock(section_mesh(Section()),
                            scene,
                            {scene::Motion(1e-3, a), scene.motion},
                            MPI_COMM_WORLD);
  coupling::CoupledState    state;
  state.continuum                 = rock.initial_state();
  continuum::ContinuumState alone = state.continuum;
  coupling::CoupledStep     step(nullptr, nullptr, &rock);
  for (int k = 0; k < 10; ++k)
    {
      EXPECT_TRUE(step.solve(state, 1e-3).converged);
      rock.step(alone, 1e-3);
    }
  EXPECT_EQ(state.continuum.displacement, alone.displacement);
  EXPECT_NEAR(state.time, 0.01, 1e-15);
}
