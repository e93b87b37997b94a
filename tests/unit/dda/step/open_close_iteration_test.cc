// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// Two squares bonded side by side, nothing below.
  FixedBaseRun bonded_pair(const double tensile_strength, const double fracture_energy)
  {
    scene::SceneParameters p             = block_parameters(30.);
    p.blocks.bonded                      = true;
    p.blocks.fracture_energy             = fracture_energy;
    p.blocks.softening_slip              = 0.;
    p.materials["rock"].tensile_strength = tensile_strength;
    p.materials["rock"].cohesion         = 10. * tensile_strength;
    p.environment.gravity                = 0.;
    return FixedBaseRun(square_blocks(2, 1), p, {});
  }



  /// The way of the lower square of a falling column in 60 ms; a third one flies far from both.
  Vec2 fall(const bool beside_another, int &iterations)
  {
    scene::SectionMesh mesh = square_blocks(1, 2);
    if (beside_another)
      {
        for (const Vec2 &corner : {Vec2(10., 50.), Vec2(11., 50.), Vec2(11., 51.), Vec2(10., 51.)})
          mesh.nodes.push_back(corner);
        mesh.blocks.push_back({6, 7, 8, 9});
        mesh.block_region.push_back(0);
      }
    FixedBaseRun run(mesh, block_parameters(30.), straight_foundation(0.05, 5., 20.));
    for (auto &block : run.state.blocks)
      block.velocity[1] = -1.;
    const Vec2 start = run.state.blocks[0].centroid;
    EXPECT_TRUE(run.run(0.06, 1e-3));
    iterations = run.iterations;
    return run.state.blocks[0].centroid - start;
  }
} // namespace



TEST(OpenCloseIteration, block_that_flies_does_not_change_what_hits)
{
  int        alone_iterations = 0, iterations = 0;
  const Vec2 alone = fall(false, alone_iterations), beside = fall(true, iterations);
  EXPECT_GT(alone.norm(), 5e-4);
  EXPECT_GT(alone_iterations, 100); // the column hits the base
  EXPECT_NEAR((alone - beside).norm(), 0., 1e-9);
}



TEST(OpenCloseIteration, free_block_needs_one_iteration)
{
  FixedBaseRun     run(square_blocks(1, 1), block_parameters(30.), {});
  const StepResult result = run.solver.solve(run.state, run.foundation, 1e-3);
  EXPECT_TRUE(result.converged);
  EXPECT_LE(result.iterations, 2);
  EXPECT_LT(result.residual, 1e-8);
}



TEST(OpenCloseIteration, unconverged_step_changes_nothing_but_contacts)
{
  scene::SceneParameters p    = block_parameters(30.);
  p.blocks.maximum_iterations = 1;
  FixedBaseRun run(square_blocks(1, 1), p, straight_foundation(0., 1., 2.));
  run.state.blocks[0].velocity << 5., -1., 2., 0., 0., 0.;
  const BlockState before = run.state.blocks[0];
  EXPECT_FALSE(run.solver.solve(run.state, run.foundation, 1e-3).converged);
  EXPECT_EQ(run.state.blocks[0].centroid, before.centroid);
  EXPECT_EQ(run.state.blocks[0].velocity, before.velocity);
  EXPECT_EQ(run.state.time, 0.);
}



TEST(OpenCloseIteration, step_that_moves_too_far_is_refused_and_names_the_block)
{
  FixedBaseRun run(square_blocks(2, 1), block_parameters(30.), {});
  run.state.blocks[1].velocity[0] = 60.; // 0.06 of its size in a step; allowed 0.05
  const StepResult result         = run.solver.solve(run.state, run.foundation, 1e-3);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.largest_block, 1);
  EXPECT_NEAR(result.displacement_ratio, 0.06, 1e-3);
}



TEST(OpenCloseIteration, bond_that_is_torn_is_counted_once_with_kind_and_time)
{
  FixedBaseRun run                = bonded_pair(1e4, 0.);
  run.state.blocks[0].velocity[0] = -0.5;
  run.state.blocks[1].velocity[0] = 0.5;
  ASSERT_TRUE(run.run(0.2, 1e-3));
  const JointState &joint = run.state.joints[0];
  EXPECT_EQ(joint.failure, FailureKind::tensile);
  EXPECT_GT(joint.failure_time, 0.);
  EXPECT_LE(joint.failure_time, 5e-3);
  EXPECT_TRUE(joint.released); // 0.2 m apart, more than a tenth of the edge
}



TEST(OpenCloseIteration, bond_that_is_sheared_is_a_shear_failure)
{
  FixedBaseRun run                = bonded_pair(1e4, 0.);
  run.state.blocks[0].velocity[1] = -1.;
  run.state.blocks[1].velocity[1] = 1.;
  for (const int b : {0, 1}) // squeezed, so that it cannot open
    run.state.blocks[b].velocity[0] = b == 0 ? 0.2 : -0.2;
  ASSERT_TRUE(run.run(5e-3, 1e-3));
  EXPECT_EQ(run.state.joints[0].failure, FailureKind::shear);
}



TEST(OpenCloseIteration, strong_bond_holds)
{
  FixedBaseRun run                = bonded_pair(1e9, 0.);
  run.state.blocks[0].velocity[0] = -0.5;
  run.state.blocks[1].velocity[0] = 0.5;
  ASSERT_TRUE(run.run(0.2, 1e-3));
  EXPECT_EQ(run.state.joints[0].failure, FailureKind::none);
  EXPECT_LT((run.state.blocks[1].centroid - run.state.blocks[0].centroid).norm(), 1.05);
}



TEST(OpenCloseIteration, base_as_a_body_moves_by_its_stiffness_and_load)
{
  // A block that rests on two nodes of a flexible foundation: S w = g + f - f_static, f = half its
  // weight.
  // Stopped after each step: contacts count as all other forces in the scheme of Shi only.
  scene::SceneParameters p = block_parameters(30.);
  p.time.newmark           = Newmark::preset("shi");
  FixedBaseRun          run(square_blocks(1, 1), p, straight_foundation(0., 0., 1., 1));
  const Eigen::MatrixXd stiffness = 1e7 * Eigen::MatrixXd::Identity(4, 4);
  run.foundation.prescribed       = false;
  run.foundation.stiffness        = &stiffness;
  run.foundation.load             = Eigen::VectorXd::Zero(4);
  run.state.contacts = {{0, 0, foundation_body, 0, 0.}, {0, 1, foundation_body, 0, 1.}};
  for (int k = 0; k < 60; ++k)
    {
      const StepResult result = run.solver.solve(run.state, run.foundation, 0.05);
      ASSERT_TRUE(result.converged) << k;
      run.solver.accept(run.state);
      for (BlockState &block : run.state.blocks)
        {
          block.velocity.setZero();
          block.acceleration.setZero();
          block.contact_acceleration.setZero();
        }
      run.foundation.displacement = run.solver.solved_step().foundation_displacement();
    }
  const double half = 0.5 * 2220. * 9.81;
  EXPECT_NEAR(run.state.foundation_displacement[1], -half / 1e7, 1e-6 * half / 1e7);
  EXPECT_NEAR(run.state.foundation_displacement[3], -half / 1e7, 1e-6 * half / 1e7);
  EXPECT_NEAR(run.state.foundation_force[1], -half, 1e-6 * half);
}



// A wall of loose blocks, each with a spin of its own, falls onto rock: contacts close, open, stick
// and slide.
TEST(OpenCloseIteration, contacts_that_change_together_save_cuts)
{
  int cuts[2];
  for (const bool together : {false, true})
    {
      FixedBaseRun run(square_blocks(5, 4),
                       block_parameters(30., 5e9),
                       straight_foundation(-0.1, 5., 10.));
      run.model.iteration.changes_together = together;
      for (int b = 0; b < 20; ++b)
        run.state.blocks[b].velocity << 1. - b % 3, -1. - b % 2, 0.5 * (b % 5) - 1., 0., 0., 0.;
      EXPECT_TRUE(run.run(0.2, 2e-3));
      cuts[together] = run.cuts;
    }
  EXPECT_LT(2 * cuts[true], cuts[false]);
}



// 60 leaning squares of 50 GPa on rock: their contacts change row by row, or all at once.
TEST(OpenCloseIteration, many_stiff_contacts_hardly_cut_a_step)
{
  int cuts[2];
  for (const bool together : {false, true})
    {
      FixedBaseRun run(square_blocks(12, 5),
                       block_parameters(15., 50e9),
                       straight_foundation(-0.1, 12., 20.));
      run.model.iteration.changes_together = together;
      for (int b = 0; b < 60; ++b)
        run.state.blocks[b].velocity << 0.01 * (b % 3), 0., 0.002 * (b % 5 - 2), 0., 0., 0.;
      EXPECT_TRUE(run.run(0.03, 1e-3));
      cuts[together] = run.cuts;
    }
  EXPECT_LE(cuts[true], 1);
  EXPECT_GT(cuts[false], 5);
}



TEST(OpenCloseIteration, a_block_that_flies_too_far_is_seen_before_anything_is_solved)
{
  FixedBaseRun run(square_blocks(2, 1), block_parameters(30.), straight_foundation(0., 1., 3.));
  for (Vec2 &x : run.state.geometry.vertices)
    x.y() += 5.;
  for (BlockState &block : run.state.blocks)
    block.centroid.y() += 5.;
  for (int v = 4; v < 8; ++v)
    run.state.geometry.vertices[v].x() += 5.;
  run.state.blocks[1].centroid.x() += 5.;
  run.state.blocks[1].velocity[0] = 60.; // 0.06 of its size in a step; allowed 0.05
  const StepResult result         = run.solver.solve(run.state, run.foundation, 1e-3);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(result.largest_block, 1);
  EXPECT_NEAR(result.displacement_ratio, 0.06, 1e-8);
}



// A wall whose upper corner is hit: few blocks settle by themselves, and all end where they do
// without.
TEST(OpenCloseIteration, few_blocks_settle_alone_and_change_no_result)
{
  int  iterations[2];
  Vec2 place[2], beside[2];
  for (const bool alone : {false, true})
    {
      FixedBaseRun run(square_blocks(50, 10),
                       block_parameters(30., 5e9),
                       straight_foundation(0., 50., 10.));
      run.model.iteration.few_settle_alone = alone;
      run.state.blocks.back().velocity << 0.5, 0.2, -0.3, 0., 0., 0.;
      EXPECT_TRUE(run.run(0.05, 1e-3));
      iterations[alone] = run.iterations;
      place[alone]      = run.state.blocks.back().centroid;
      beside[alone]     = run.state.blocks[run.state.blocks.size() - 3].centroid;
    }
  EXPECT_LT(iterations[true], 0.9 * iterations[false]);
  EXPECT_LT((place[true] - place[false]).norm(), 1e-6);
  EXPECT_LT((beside[true] - beside[false]).norm(), 1e-6);
}
