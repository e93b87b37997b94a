// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/block_strikes.h>

#include <gtest/gtest.h>

namespace hybrid::output
{
  namespace
  {
    /// Blocks that had @p kinetic and came to rest, of which the steps took @p taken [J/m].
    EnergyLedger ledger_with(const double kinetic, const double taken)
    {
      EnergyLedger           ledger(false);
      coupling::CoupledState state;
      ledger.update(state);
      ledger.note_kinetic_of_blocks(kinetic); // in a step without an audit
      state.blocks.energy.friction_loss    = kinetic - taken;
      state.blocks.energy.integration_loss = taken;
      ledger.update(state);
      return ledger;
    }



    TEST(BlockStrikes, are_seen_by_what_steps_take_of_the_largest_kinetic_energy)
    {
      EXPECT_TRUE(blocks_strike(3, ledger_with(100., 4.)));
      EXPECT_FALSE(blocks_strike(3, ledger_with(100., 2.)));
    }



    TEST(BlockStrikes, take_two_blocks)
    {
      EXPECT_FALSE(blocks_strike(1, ledger_with(100., 50.)));
      EXPECT_TRUE(blocks_strike(2, ledger_with(100., 50.)));
    }



    TEST(BlockStrikes, are_none_where_nothing_moves)
    {
      EXPECT_FALSE(blocks_strike(2, ledger_with(0., 0.)));
    }
  } // namespace
} // namespace hybrid::output
