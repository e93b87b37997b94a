// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that touch nothing: the parabola, and a spin that neither grows nor gains energy.
#include "block_scenes.h"

#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/dda/step/block_energy.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  double area(const dda::Geometry &g, const int block)
  {
    return dda::polygon_moments(&g.vertices[g.offset[block]], g.offset[block + 1] - g.offset[block])
      .area;
  }
} // namespace



TEST(BlockFlight, thrown_block_follows_the_parabola_to_round_off)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      scene::SceneParameters p = block_parameters(30.);
      p.time.newmark           = Newmark::preset(preset);
      FixedBaseRun run(square_blocks(1, 1), p, {});
      run.state.blocks[0].velocity[0]     = 3.;
      run.state.blocks[0].velocity[1]     = 4.;
      run.state.blocks[0].acceleration[1] = -9.81;
      const Vec2 start                    = run.state.blocks[0].centroid;
      ASSERT_TRUE(run.run(2., 1e-3));
      const double t        = run.state.time;
      const Vec2   expected = start + Vec2(3. * t, 4. * t - 0.5 * 9.81 * t * t);
      EXPECT_LT((run.state.blocks[0].centroid - expected).norm(), 1e-10) << preset;
      EXPECT_NEAR(run.state.blocks[0].velocity[1], 4. - 9.81 * t, 1e-10) << preset;
      EXPECT_EQ(run.cuts, 0);
    }
}



TEST(BlockFlight, falls_with_gravity_from_the_first_step)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      scene::SceneParameters p = block_parameters(30.);
      p.time.newmark           = Newmark::preset(preset);
      FixedBaseRun run(square_blocks(1, 1), p, {});
      ASSERT_TRUE(run.advance(1e-3, 0));
      EXPECT_NEAR(run.state.blocks[0].velocity[1], -9.81e-3, 1e-12) << preset;
      ASSERT_TRUE(run.run(1., 1e-3));
      EXPECT_NEAR(run.state.blocks[0].velocity[1], -9.81, 1e-10) << preset;
    }
}



TEST(BlockFlight, spinning_block_keeps_its_area_for_a_hundred_turns)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      scene::SceneParameters p = block_parameters(30.);
      p.environment.gravity    = 0.;
      p.time.newmark           = Newmark::preset(preset);
      FixedBaseRun run(square_blocks(1, 1), p, {});
      run.state.blocks[0].velocity[2] = 2. * M_PI * 5.;
      ASSERT_TRUE(run.run(20., 1e-3));
      EXPECT_NEAR(run.state.blocks[0].rotation, 2. * M_PI * 100., 0.01 * 2. * M_PI) << preset;
      EXPECT_NEAR(area(run.state.geometry, 0), 1., 1e-10) << preset;
      EXPECT_EQ(run.cuts, 0);
    }
}



TEST(BlockFlight, spinning_bonded_pair_neither_grows_nor_gains_energy)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      scene::SceneParameters p             = block_parameters(30.);
      p.environment.gravity                = 0.;
      p.blocks.bonded                      = true;
      p.materials["rock"].tensile_strength = 1e9;
      p.materials["rock"].cohesion         = 1e9;
      p.time.newmark                       = Newmark::preset(preset);
      FixedBaseRun run(square_blocks(2, 1), p, {});
      const double spin = 2. * M_PI;
      for (int b = 0; b < 2; ++b)
        {
          run.state.blocks[b].velocity[1] = (b == 0 ? -0.5 : 0.5) * spin;
          run.state.blocks[b].velocity[2] = spin;
        }
      const double start    = dda::stored_energy(run.model, run.state).kinetic;
      double       distance = 0., energy = 0.;
      for (int turn = 0; turn < 10; ++turn)
        {
          ASSERT_TRUE(run.run(turn + 1., 1e-3));
          const dda::BlockEnergy held = dda::stored_energy(run.model, run.state);
          energy                      = std::max(energy, held.kinetic + held.strain + held.springs);
          distance                    = std::max(distance,
                              (run.state.blocks[1].centroid - run.state.blocks[0].centroid).norm());
        }
      EXPECT_NEAR(distance, 1., 2e-3) << preset; // elastic stretch is 1e-3
      EXPECT_LT(energy, 1.001 * start) << preset;
      for (int b = 0; b < 2; ++b)
        EXPECT_NEAR(area(run.state.geometry, b), 1., 2e-3) << preset;
    }
}
