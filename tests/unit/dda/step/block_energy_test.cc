// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/dda/step/block_energy.h>
#include <hybrid/dda/step/initial_state.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// Bonds that do not break, without gravity, with Newmark's weights of a preset.
  scene::SceneParameters strongly_bonded(const char *preset)
  {
    scene::SceneParameters p             = block_parameters(30.);
    p.blocks.bonded                      = true;
    p.materials["rock"].tensile_strength = 1e9;
    p.materials["rock"].cohesion         = 1e9;
    p.environment.gravity                = 0.;
    p.time.newmark                       = Newmark::preset(preset);
    return p;
  }
} // namespace



TEST(BlockEnergy, held_energy_is_kinetic_plus_strain)
{
  const Model model = build_model(square_blocks(1, 1), block_parameters(30.), {});
  DdaState    state = initial_state(model);
  state.blocks[0].velocity << 3., 4., 2., 0., 0., 0.;
  state.blocks[0].stress << 1e4, 0., 0.;
  const BlockEnergy e = stored_energy(model, state);
  EXPECT_NEAR(e.kinetic, 0.5 * 2220. * (25. + 4. / 6.), 1e-9);
  const double nu = 0.25, E = 50e6; // plane strain under uniaxial stress
  EXPECT_NEAR(e.strain, 0.5 * 1e8 * (1. - nu * nu) / E, 1e-9);
  EXPECT_EQ(e.springs, 0.);
}



TEST(BlockEnergy, free_fall_exchanges_gravity_and_kinetic_energy)
{
  FixedBaseRun run(square_blocks(1, 1), block_parameters(30.), {});
  run.state.blocks[0].acceleration[1] = -9.81;
  const double fall                   = 0.5 * 9.81 * 0.25;
  run.state.energy                    = stored_energy(run.model, run.state);
  // the acceleration term of the scheme belongs to what is held
  const double start = run.state.energy.balance();
  ASSERT_TRUE(run.run(0.5, 1e-3));
  EXPECT_NEAR(run.state.energy.kinetic, 2220. * 9.81 * fall, 1e-9 * 2220. * 9.81 * fall);
  EXPECT_NEAR(run.state.energy.gravity, -2220. * 9.81 * fall, 1e-9 * 2220. * 9.81 * fall);
  EXPECT_NEAR(run.state.energy.balance(), start, 1e-9 * 2220. * 9.81 * fall);
}



TEST(BlockEnergy, vibrating_bonded_pair_balances)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      scene::SceneParameters p = strongly_bonded(preset);
      p.blocks.damping_ratio   = 0.02;
      FixedBaseRun run(square_blocks(2, 1), p, {});
      run.state.blocks[0].velocity[0] = 0.1;
      run.state.energy                = stored_energy(run.model, run.state);
      const double start              = run.state.energy.balance();
      ASSERT_TRUE(run.run(0.2, 1e-3));
      EXPECT_NEAR(run.state.energy.balance(), start, 1e-3 * start) << preset;
      EXPECT_GT(run.state.energy.damping_loss, 0.);
      EXPECT_GE(run.state.energy.integration_loss, -1e-9 * start);
    }
}



TEST(BlockEnergy, maxwell_branches_lose_in_every_step)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      scene::SceneParameters p = strongly_bonded(preset);
      p.maxwell.block_ratio    = 0.2;
      p.maxwell.lowest         = 2.;
      p.maxwell.highest        = 20.;
      FixedBaseRun run(square_blocks(2, 1), p, {});
      run.state.blocks[0].velocity    = Vec6::Unit(0) * 0.1;
      run.state.blocks[0].velocity[5] = 0.2;
      run.state.blocks[1].velocity[2] = 0.05; // the pair turns
      run.state.energy                = stored_energy(run.model, run.state);
      const double start              = run.state.energy.balance();
      while (run.state.time < 0.2)
        {
          const double before = run.state.energy.damping_loss;
          ASSERT_TRUE(run.advance(1e-3, 0));
          ASSERT_GT(run.state.energy.damping_loss, before) << preset;
        }
      EXPECT_NEAR(run.state.energy.balance(), start, 1e-3 * start) << preset;
      EXPECT_GT(run.state.energy.damping_loss, 0.05 * start) << preset;
      EXPECT_NEAR(run.state.energy.strain,
                  stored_energy(run.model, run.state).strain,
                  1e-9 * start);
    }
}



// A joint with the damage D has k_n closed and (1 - D) k_n open. In Newmark's weights all of it
// would give D k_n |g_0 g_1| / 2 per length when a step takes it from the overlap g_0 to the
// opening g_1.
TEST(BlockEnergy, damaged_joint_that_opens_and_closes_gives_nothing)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    for (const double damage : {0.3, 0.9, 0.999})
      {
        const scene::SceneParameters p = strongly_bonded(preset);
        FixedBaseRun                 run(square_blocks(2, 1), p, {});
        for (SpringState &end : run.state.joints[0].points)
          end.history.damage = damage;
        run.state.blocks[0].velocity    = Vec6::Unit(0) * 0.1;
        run.state.blocks[0].velocity[2] = 0.05;
        run.state.energy                = stored_energy(run.model, run.state);
        const double start              = run.state.energy.balance();
        while (run.state.time < 0.2)
          {
            // What a filter stores may come back.
            const double before =
              run.model.newmark.filter > 0. ? 0. : run.state.energy.integration_loss;
            ASSERT_TRUE(run.advance(1e-3, 0));
            ASSERT_GE(run.state.energy.integration_loss - before, -1e-6 * start)
              << preset << ", damage " << damage << ", " << run.state.time << " s";
          }
        EXPECT_NEAR(run.state.energy.balance(), start, 1e-4 * start) << preset << damage;
      }
}



// A square that hangs on one end of its joint turns about it. Springs act across the mean direction
// of the two edges: at 180 degrees that turned round, the torn end lay 2 m deep in the other square
// and made 3e9 J/m.
TEST(BlockEnergy, square_that_turns_about_an_end_of_its_joint_gains_nothing)
{
  scene::SceneParameters p             = block_parameters(30.);
  p.blocks.bonded                      = true;
  p.materials["rock"].tensile_strength = 1e9;
  p.materials["rock"].cohesion         = 1e9;
  p.environment.gravity                = 0.;
  FixedBaseRun run(square_blocks(2, 1), p, {});
  run.state.joints[0].points[1].history.damage = 1.; // at (1, 1)
  const double spin                            = -3.;
  const Vec2   arm                             = run.state.blocks[1].centroid - Vec2(1., 0.);
  run.state.blocks[1].velocity << -spin * arm.y(), spin * arm.x(), spin, 0., 0., 0.;
  run.state.energy   = stored_energy(run.model, run.state);
  const double start = run.state.energy.balance();
  ASSERT_TRUE(run.run(1., 1e-3));
  EXPECT_NEAR(run.state.energy.balance(), start, 1e-4 * start);
  EXPECT_LT(run.state.energy.kinetic, start);
  EXPECT_EQ(run.cuts, 0);
}



TEST(BlockEnergy, sliding_block_turns_its_fall_into_friction)
{
  const double angle = 30. * M_PI / 180.;
  FixedBaseRun run(square_blocks(1, 1, 1., angle),
                   block_parameters(15.),
                   straight_foundation(angle, 20., 20.));
  ASSERT_TRUE(settle(run.model, run.state, true).equilibrium);
  const Vec2   from  = run.state.blocks[0].centroid;
  const double start = run.state.energy.balance();
  ASSERT_TRUE(run.run(0.5, 1e-3));
  const double slip   = (run.state.blocks[0].centroid - from).norm();
  const double weight = 2220. * 9.81;
  EXPECT_NEAR(run.state.energy.friction_loss,
              weight * std::cos(angle) * std::tan(15. * M_PI / 180.) * slip,
              5e-3 * weight * slip);
  EXPECT_NEAR(run.state.energy.balance(), start, 1e-3 * weight * slip);
}



TEST(BlockEnergy, dynamic_coefficient_takes_its_part_of_the_kinetic_energy)
{
  scene::SceneParameters p   = block_parameters(30.);
  p.environment.gravity      = 0.;
  p.time.time_step           = 1e-3;
  p.time.dynamic_coefficient = 0.98;
  for (const double dt : {1e-3, 0.25e-3}) // the given step, and one that was cut
    {
      FixedBaseRun run(square_blocks(1, 1), p, {});
      run.state.blocks[0].velocity[0] = 1.;
      run.state.energy                = stored_energy(run.model, run.state);
      const double start              = run.state.energy.balance();
      ASSERT_TRUE(run.run(0.01, dt));
      EXPECT_NEAR(run.state.energy.kinetic, start * std::pow(0.98, 20.), 1e-9 * start);
      EXPECT_NEAR(run.state.energy.balance(), start, 1e-9 * start);
    }
}
