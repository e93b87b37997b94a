// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/energy_ledger.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using output::EnergyLedger;

  double sum(const std::vector<double> &terms)
  {
    double result = 0.;
    for (const double term : terms)
      result += term;
    return result;
  }
} // namespace



TEST(EnergyLedger, names_and_values_go_together)
{
  for (const bool with_continuum : {false, true})
    {
      EnergyLedger           ledger(with_continuum);
      coupling::CoupledState state;
      EXPECT_EQ(ledger.update(state).size(), ledger.names().size());
    }
}



TEST(EnergyLedger, counts_from_the_first_state)
{
  EnergyLedger           ledger(false);
  coupling::CoupledState state;
  state.blocks.energy.springs = 100.;
  state.blocks.energy.strain  = 50.;
  ledger.update(state);
  EXPECT_EQ(sum(ledger.values()), 0.);
  EXPECT_EQ(ledger.residual(), 0.);
}



// What moves at the start is in play: the residual is relative to it, though nothing is exchanged.
TEST(EnergyLedger, motion_at_the_start_counts)
{
  EnergyLedger           ledger(true);
  coupling::CoupledState state;
  state.blocks.energy.kinetic    = 30.;
  state.continuum.energy.kinetic = 70.;
  ledger.update(state);
  EXPECT_EQ(ledger.at_start()[0], 30.);
  state.blocks.energy.kinetic = 29.;
  ledger.update(state);
  EXPECT_NEAR(ledger.residual(), 0.01, 1e-9);
}



// A block falls and is stopped by friction: kinetic energy rises, gravity falls, then heat remains.
TEST(EnergyLedger, a_closed_balance_has_no_residual)
{
  EnergyLedger           ledger(false);
  coupling::CoupledState state;
  ledger.update(state);
  state.blocks.energy.kinetic = 30.;
  state.blocks.energy.gravity = -30.;
  ledger.update(state);
  EXPECT_EQ(ledger.residual(), 0.);
  state.blocks.energy.kinetic       = 0.;
  state.blocks.energy.friction_loss = 30.;
  ledger.update(state);
  EXPECT_EQ(ledger.residual(), 0.);
}



TEST(EnergyLedger, what_is_missing_is_shown_over_what_was_exchanged)
{
  EnergyLedger           ledger(false);
  coupling::CoupledState state;
  ledger.update(state);
  state.blocks.energy.kinetic = 98.;
  state.blocks.energy.gravity = -100.;
  ledger.update(state);
  EXPECT_DOUBLE_EQ(ledger.residual(), 2. / 198.);
  // The scale stays when the exchange goes back, and so does the largest residual.
  state.blocks.energy.kinetic = 0.;
  state.blocks.energy.gravity = -1.;
  ledger.update(state);
  EXPECT_DOUBLE_EQ(ledger.residual(), 1. / 198.);
  EXPECT_DOUBLE_EQ(ledger.largest_residual(), 2. / 198.);
}



TEST(EnergyLedger, work_of_the_base_pays_for_the_blocks)
{
  EnergyLedger           ledger(false);
  coupling::CoupledState state;
  ledger.update(state);
  state.blocks.energy.kinetic         = 7.;
  state.blocks.energy.foundation_work = 7.;
  ledger.update(state);
  EXPECT_EQ(ledger.residual(), 0.);
}



// Between rock and blocks work changes hands: neither side's interface work is a term of the whole,
// but the static forces that the rock carries are its prestress.
TEST(EnergyLedger, incident_work_pays_for_rock_blocks_and_boundary)
{
  EnergyLedger           ledger(true);
  coupling::CoupledState state;
  state.blocks.static_force            = Eigen::VectorXd::Constant(4, -10.);
  state.blocks.foundation_displacement = Eigen::VectorXd::Zero(4);
  ledger.update(state);
  state.continuum.energy.input_work    = 20.;
  state.continuum.energy.kinetic       = 5.;
  state.continuum.energy.strain        = 4.;
  state.continuum.energy.boundary_loss = 3.;
  state.blocks.energy.kinetic          = 2.;
  state.blocks.energy.gravity          = 8.;
  state.blocks.foundation_displacement.setConstant(0.05); // lifted: the prestress falls by 2
  ledger.update(state);
  EXPECT_NEAR(sum(ledger.values()), 0., 1e-14);
}



TEST(EnergyLedger, quiet_states_have_a_floor)
{
  EnergyLedger           ledger(false);
  coupling::CoupledState state;
  ledger.update(state);
  state.blocks.energy.kinetic = 1e-9;
  ledger.update(state);
  EXPECT_DOUBLE_EQ(ledger.residual(), 1e-6);
}



// A block that drops on a rod: the scheme's two terms cancel, and half of what is in play is gone.
TEST(EnergyLedger, terms_of_the_scheme_do_not_hide_an_imbalance)
{
  EnergyLedger           ledger(true);
  coupling::CoupledState state;
  ledger.update(state);
  state.blocks.energy.gravity                 = -785e3;
  state.blocks.energy.kinetic                 = 324e3;
  state.blocks.energy.spring_replacement_loss = -4.5e8;
  state.blocks.energy.integration_loss        = 4.5e8;
  ledger.update(state);
  EXPECT_NEAR(ledger.sum(), -461e3, 1.);
  EXPECT_NEAR(ledger.residual(), 461. / 1109., 1e-6);
  EXPECT_GT(ledger.scheme_fraction(), 800.);
  EXPECT_EQ(ledger.largest_changes(1)[0].name, "blocks_integration_loss");
}



// What passes between blocks and bedrock stands in both terms of the time integration.
TEST(EnergyLedger, time_integration_of_blocks_and_bedrock_counts_together)
{
  EnergyLedger           ledger(true);
  coupling::CoupledState state;
  ledger.update(state);
  state.blocks.energy.kinetic             = 100.;
  state.blocks.energy.integration_loss    = -7.;
  state.continuum.energy.integration_loss = 8.;
  ledger.update(state);
  EXPECT_DOUBLE_EQ(ledger.scheme_fraction(), 0.01);
  EXPECT_EQ(ledger.given_by_scheme(), 0.);
  EXPECT_EQ(ledger.scheme_terms().size(), 3u) << "all are told";
}



// The ground lifts a mass: its gain against gravity is the rock's loss of static stress, nothing is
// in play but what moves.
TEST(EnergyLedger, lifted_mass_and_rock_are_no_energy_in_play)
{
  EnergyLedger           ledger(true);
  coupling::CoupledState state;
  state.blocks.static_force            = Eigen::VectorXd::Constant(2, -1e6);
  state.blocks.foundation_displacement = Eigen::VectorXd::Zero(2);
  ledger.update(state);
  state.blocks.foundation_displacement[1] = 1.;
  state.blocks.energy.gravity             = 1e6;
  state.blocks.energy.kinetic             = 10.;
  state.continuum.energy.input_work       = 8.;
  ledger.update(state);
  EXPECT_NEAR(ledger.residual(), 2. / 18., 1e-9);
}



// An early misfit of a run in which much more is exchanged later is no large residual of the run.
TEST(EnergyLedger, the_largest_residual_is_over_what_the_run_exchanged)
{
  EnergyLedger           ledger(false);
  coupling::CoupledState state;
  ledger.update(state);
  state.blocks.energy.kinetic = 62.2;
  state.blocks.energy.gravity = -62.;
  ledger.update(state);
  state.blocks.energy.kinetic = 89e3;
  state.blocks.energy.gravity = -89e3;
  ledger.update(state);
  EXPECT_NEAR(ledger.largest_residual(), 0.2 / 178e3, 1e-12);
}
