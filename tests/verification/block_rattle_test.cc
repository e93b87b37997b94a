// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts that are much stiffer than a step resolves do not throw blocks to and fro.
#include "block_scenes.h"

#include <hybrid/dda/step/block_energy.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  constexpr double speed = 0.01; // m/s

  /// A column of hard squares, pressed to the base by its weight, gets a push downwards.
  struct PushedColumn : FixedBaseRun
  {
    PushedColumn(const char *preset, const int rows, const double young_modulus = 50e9)
      : FixedBaseRun(square_blocks(1, rows),
                     parameters(preset, young_modulus),
                     straight_foundation(0., 2., 3.))
    {
      for (dda::BlockState &block : state.blocks)
        block.velocity[1] = -speed;
      state.energy = dda::stored_energy(model, state);
    }

    static scene::SceneParameters parameters(const char *preset, const double young_modulus)
    {
      scene::SceneParameters p = block_parameters(30., young_modulus);
      p.time.newmark           = Newmark::preset(preset);
      return p;
    }
  };



  double largest_rate(const dda::DdaState &state)
  {
    double largest = 0.;
    for (const dda::BlockState &block : state.blocks)
      largest = std::max(largest, std::abs(block.velocity[1]));
    return largest;
  }



  double rate_after(const char *preset, const int rows, const int steps)
  {
    PushedColumn run(preset, rows);
    const double start = run.state.energy.balance();
    for (int step = 0; step < steps; ++step)
      EXPECT_TRUE(run.advance(1e-3, 0)) << preset << ' ' << step;
    const dda::BlockEnergy &energy = run.state.energy;
    EXPECT_NEAR(energy.balance(), start, 1e-8 * start) << preset;
    return largest_rate(run.state);
  }
} // namespace



TEST(BlockRattle, a_filtered_velocity_dies_out_on_a_stiff_contact)
{
  for (const int rows : {1, 3})
    EXPECT_LE(rate_after("filtered", rows, 40), 1e-3 * speed) << rows;
}



TEST(BlockRattle, without_the_filter_it_is_thrown_back_in_each_step)
{
  EXPECT_GE(rate_after("dissipative", 1, 40), 0.02 * speed);
  EXPECT_GE(rate_after("shi", 1, 40), 0.02 * speed);
}



TEST(BlockRattle, a_velocity_keeps_what_the_closed_form_says)
{
  PushedColumn run("filtered", 1, 5e12); // all but rigid
  for (int step = 0; step < 16; ++step)
    ASSERT_TRUE(run.advance(1e-3, 0));
  const double g        = Newmark::preset("filtered").velocity_filter;
  const double root     = std::sqrt(std::pow(1. - 4. * g, 2) + 4. * (2. + 2. * g) * (1. - 2. * g));
  const double expected = (-(1. - 4. * g) - root) / (2. * (2. + 2. * g));
  const double before   = run.state.blocks[0].velocity[1];
  ASSERT_TRUE(run.advance(1e-3, 0));
  EXPECT_NEAR(run.state.blocks[0].velocity[1] / before, expected, 0.02);
}
