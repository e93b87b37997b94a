// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/dda/step/block_energy.h>
#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  constexpr double dt = 1e-3; ///< [s]

  std::string bytes(DdaState &state)
  {
    restart::Archive archive = restart::Archive::writer();
    archive(state);
    return archive.content();
  }



  constexpr double slope = 2. * M_PI / 180.;

  /// A wall of squares that leans a little, at rest.
  struct SleepyWall : FixedBaseRun
  {
    explicit SleepyWall(const bool sleeps)
      : FixedBaseRun(square_blocks(4, 3, 1., slope),
                     block_parameters(25., 50e9),
                     straight_foundation(slope, 5., 10.))
    {
      model.iteration.sleeps = sleeps;
      EXPECT_TRUE(settle(model, state).equilibrium);
    }
  };



  scene::SceneParameters damped_rock()
  {
    scene::SceneParameters p = block_parameters(25., 50e6);
    p.blocks.damping_ratio   = 0.2;
    return p;
  }

  /// Three squares above each other, the highest 20 mm above the others.
  struct Fall : FixedBaseRun
  {
    explicit Fall(const bool sleeps)
      : FixedBaseRun(square_blocks(1, 3), damped_rock(), straight_foundation(0., 2., 3.))
    {
      model.iteration.sleeps = sleeps;
      for (int v = state.geometry.offset[2]; v < state.geometry.offset[3]; ++v)
        state.geometry.vertices[v].y() += 0.02;
      state.blocks[2].centroid.y() += 0.02;
    }
  };



  /// What happened besides the states.
  struct Counts
  {
    std::vector<bool> slept;            ///< per step
    int               asleep       = 0; ///< steps
    int               last_asleep  = -1;
    int               first_asleep = -1;
    bool              moves        = false; ///< at the end
  };

  /// Steps one run that may sleep and one that computes all, and compares them after each step.
  /// @p before is called before step k of each.
  Counts compare(FixedBaseRun                                   &sleeper,
                 FixedBaseRun                                   &other,
                 const int                                       steps,
                 const std::function<void(FixedBaseRun &, int)> &before)
  {
    Counts counts;
    for (int k = 0; k < steps; ++k)
      {
        for (FixedBaseRun *run : {&sleeper, &other})
          {
            before(*run, k);
            EXPECT_TRUE(run->advance(dt, 10));
          }
        EXPECT_FALSE(other.solver.slept());
        EXPECT_EQ(bytes(sleeper.state), bytes(other.state)) << "step " << k;
        counts.slept.push_back(sleeper.solver.slept());
        if (!sleeper.solver.slept())
          continue;
        ++counts.asleep;
        counts.last_asleep = k;
        if (counts.first_asleep < 0)
          counts.first_asleep = k;
      }
    EXPECT_EQ(sleeper.steps, other.steps);
    EXPECT_EQ(sleeper.iterations, other.iterations);
    EXPECT_EQ(sleeper.cuts, other.cuts);
    EXPECT_EQ(sleeper.solver.search().steps, other.solver.search().steps);
    EXPECT_EQ(sleeper.solver.search().searches, other.solver.search().searches);
    EXPECT_EQ(sleeper.solver.search().lists, other.solver.search().lists);
    for (const BlockState &block : sleeper.state.blocks)
      counts.moves = counts.moves || block.velocity.norm() > 0.;
    return counts;
  }

  const auto nothing = [](FixedBaseRun &, int) {};
} // namespace



TEST(Sleep, mass_at_rest_sleeps_after_a_few_steps_with_the_same_bits)
{
  SleepyWall   sleeper(true), other(false);
  const Counts counts = compare(sleeper, other, 20, nothing);
  EXPECT_LE(counts.first_asleep, 8);
  EXPECT_EQ(counts.asleep, 20 - counts.first_asleep);
  EXPECT_FALSE(counts.moves);
  EXPECT_NEAR(sleeper.state.time, 20 * dt, 1e-12);
}



TEST(Sleep, load_that_rises_wakes_it)
{
  const auto load = [](FixedBaseRun &run, const int k) {
    if (k > 0)
      return;
    run.model.edge_loads.edges     = {{11, 4 * 11 + 1, Vec2(-2e4, 0.)}}; // most of its weight
    run.model.edge_loads.start     = 20.5 * dt;
    run.model.edge_loads.rise_time = 10. * dt;
  };
  SleepyWall   sleeper(true), other(false);
  const Counts counts = compare(sleeper, other, 60, load);
  EXPECT_GT(counts.asleep, 10);
  EXPECT_LE(counts.last_asleep, 19);
  EXPECT_TRUE(counts.moves);
}



TEST(Sleep, level_that_changes_wakes_it)
{
  const auto level = [](FixedBaseRun &run, const int k) {
    if (k > 0)
      return;
    // from below the wall to its middle
    run.model.water         = {Water::Action::buoyancy, -9., 9810.};
    run.model.water.history = std::make_shared<const scene::LinearTable>(
      scene::LinearTable{{{20.5 * dt, -9.}, {50. * dt, 1.5}}});
  };
  SleepyWall   sleeper(true), other(false);
  const Counts counts = compare(sleeper, other, 80, level);
  EXPECT_GT(counts.asleep, 10);
  for (int k = 20; k < 50; ++k)
    EXPECT_FALSE(counts.slept[k]) << "step " << k;
}



TEST(Sleep, base_that_moves_wakes_it)
{
  const auto shake = [](FixedBaseRun &run, const int k) {
    if (k >= 20 && k < 25)
      run.foundation.displacement.setConstant(1e-5 * (k - 19));
  };
  SleepyWall   sleeper(true), other(false);
  const Counts counts = compare(sleeper, other, 40, shake);
  EXPECT_GT(counts.asleep, 10);
  EXPECT_TRUE(counts.slept[19]);
  for (int k = 20; k < 25; ++k)
    EXPECT_FALSE(counts.slept[k]);
  EXPECT_EQ(sleeper.state.foundation_displacement[0], 5e-5);
}



TEST(Sleep, step_of_another_size_is_computed)
{
  SleepyWall run(true);
  for (int k = 0; k < 20; ++k)
    EXPECT_TRUE(run.advance(dt, 0));
  EXPECT_TRUE(run.solver.slept());
  EXPECT_TRUE(run.advance(0.5 * dt, 0));
  EXPECT_FALSE(run.solver.slept());
}



// What falls keeps all awake, and what it has met sleeps when all is at rest again.
TEST(Sleep, block_that_falls_wakes_what_it_meets)
{
  Fall         sleeper(true), other(false);
  double       lowest = 0.;
  const Counts counts = compare(sleeper, other, 3000, [&](FixedBaseRun &run, int) {
    lowest = std::min(lowest, run.state.blocks[2].velocity[1]);
  });
  EXPECT_LT(lowest, -0.5); // 0.63 m/s in free fall
  EXPECT_GT(counts.first_asleep, 60);
  EXPECT_GT(counts.asleep, 100);
  EXPECT_FALSE(counts.moves);
  EXPECT_NEAR(sleeper.state.blocks[2].centroid.y(), 2.5, 0.01);
}



// A run that goes on from a state that slept comes to the same.
TEST(Sleep, state_that_slept_can_be_gone_on_from)
{
  SleepyWall first(true), second(true);
  for (int k = 0; k < 20; ++k)
    EXPECT_TRUE(first.advance(dt, 0));
  EXPECT_TRUE(first.solver.slept());
  second.state = first.state;
  for (int k = 0; k < 10; ++k)
    {
      EXPECT_TRUE(first.advance(dt, 0));
      EXPECT_TRUE(second.advance(dt, 0));
      EXPECT_EQ(bytes(first.state), bytes(second.state));
    }
  EXPECT_TRUE(second.solver.slept());
}



// The tolerance is that of the whole mass: what is light among heavy blocks must not hang in the
// air.
TEST(Sleep, light_block_beside_heavy_ones_falls)
{
  FixedBaseRun     run(square_blocks(1, 2), block_parameters(25.), straight_foundation(0., 2., 3.));
  BlockProperties &light = run.model.blocks[1];
  for (double *value : {&light.mass, &light.weight, &light.sxx, &light.sxy, &light.syy})
    *value *= 1e-10;
  light.elasticity *= 1e-10;
  ASSERT_TRUE(settle(run.model, run.state).equilibrium);
  for (int v = run.state.geometry.offset[1]; v < run.state.geometry.offset[2]; ++v)
    run.state.geometry.vertices[v].y() += 0.5;
  BlockState &block = run.state.blocks[1];
  block.centroid.y() += 0.5;
  block.acceleration << 0., -9.81, 0., 0., 0., 0.;
  block.contact_acceleration.setZero();
  for (int k = 0; k < 10; ++k)
    EXPECT_TRUE(run.advance(dt, 0));
  EXPECT_FALSE(run.solver.slept());
  EXPECT_NEAR(block.velocity[1], -9.81 * 10. * dt, 1e-6);
}



// Blocks that stop lose what they had to the integration: the audit closes.
TEST(Sleep, energy_of_blocks_that_stop_is_accounted_for)
{
  SleepyWall run(true);
  for (BlockState &block : run.state.blocks)
    block.velocity[0] = 1e-10; // 3e-7 of g in a step: below what a step can tell from rest
  run.state.energy     = stored_energy(run.model, run.state);
  const double before  = run.state.energy.balance();
  const double kinetic = run.state.energy.kinetic;
  for (int k = 0; k < 20; ++k)
    EXPECT_TRUE(run.advance(dt, 0));
  EXPECT_TRUE(run.solver.slept());
  EXPECT_GT(kinetic, 0.);
  EXPECT_EQ(run.state.energy.kinetic, 0.);
  EXPECT_NEAR(run.state.energy.balance(), before, 1e-12 * run.state.energy.springs);
}
