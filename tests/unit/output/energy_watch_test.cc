// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/energy_watch.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using output::EnergyLedger;
  using output::EnergyWatch;

  /// A fall of 100 J/m that gives @p kinetic.
  EnergyLedger fallen(const double kinetic)
  {
    EnergyLedger           ledger(false);
    coupling::CoupledState state;
    ledger.update(state);
    state.blocks.energy.gravity = -100.;
    state.blocks.energy.kinetic = kinetic;
    ledger.update(state);
    return ledger;
  }
} // namespace



TEST(EnergyWatch, warns_once_and_says_what_changed)
{
  EnergyWatch watch(0.01, 0.05);
  EXPECT_EQ(watch.look(fallen(101.), 0.1), "");
  const std::string text = watch.look(fallen(104.), 0.2);
  EXPECT_NE(
    text.find(
      "the energy audit does not close at t = 0.2 s: 4 J/m were created, 1.96 % of the 204 J/m in play"),
    std::string::npos)
    << text;
  EXPECT_NE(text.find("blocks_kinetic 104, blocks_gravity -100"), std::string::npos) << text;
  EXPECT_FALSE(watch.is_over(fallen(104.)));
  EXPECT_EQ(watch.look(fallen(105.), 0.3), "");
}



TEST(EnergyWatch, stops_at_the_limit)
{
  EnergyWatch watch(0.01, 0.05);
  EXPECT_TRUE(watch.is_over(fallen(80.)));
  EXPECT_NE(watch.look(fallen(80.), 0.4).find("20 J/m were lost"), std::string::npos);
}



TEST(EnergyWatch, zero_is_never)
{
  EnergyWatch watch(0., 0.);
  EXPECT_FALSE(watch.is_over(fallen(20.)));
  EXPECT_EQ(watch.look(fallen(20.), 0.4), "");
}



TEST(EnergyWatch, names_what_the_scheme_took)
{
  EnergyLedger           ledger(false);
  coupling::CoupledState state;
  ledger.update(state);
  state.blocks.energy.gravity          = -100.;
  state.blocks.energy.kinetic          = 90.;
  state.blocks.energy.integration_loss = 10.;
  ledger.update(state);
  const std::string text = EnergyWatch(0.01, 0.05).of_scheme(ledger);
  EXPECT_NE(text.find("5.26 % of the 190 J/m"), std::string::npos) << text;
  EXPECT_NE(text.find("blocks_integration_loss 10"), std::string::npos) << text;
  EXPECT_EQ(EnergyWatch(0.1, 0.05).of_scheme(ledger), "");
}



TEST(EnergyWatch, what_rings_as_weights_settle_is_no_motion)
{
  EnergyLedger           ledger(false);
  coupling::CoupledState state;
  ledger.update(state);
  state.blocks.energy.gravity          = -100.;
  state.blocks.energy.strain           = 90.;
  state.blocks.energy.integration_loss = 10.;
  ledger.update(state);
  EXPECT_EQ(EnergyWatch(0.01, 0.05).of_scheme(ledger, 191.), "");
  EXPECT_NE(EnergyWatch(0.01, 0.05).of_scheme(ledger, 189.), "");
}



TEST(EnergyWatch, warns_where_the_scheme_gives_after_it_took_more)
{
  EnergyLedger           ledger(false);
  coupling::CoupledState state;
  EnergyWatch            watch(0.01, 0.05);
  const auto             look = [&](const double kinetic) {
    state.blocks.energy.gravity          = -100.;
    state.blocks.energy.kinetic          = kinetic;
    state.blocks.energy.integration_loss = 100. - kinetic;
    ledger.update(state);
    return watch.look(ledger, 0.1);
  };
  ledger.update(state);
  EXPECT_EQ(look(50.), ""); // taken
  EXPECT_EQ(look(55.), ""); // 5 of 155 J/m
  EXPECT_NE(look(60.).find("gives energy until t = 0.1 s: 6.25 % of the 160 J/m"),
            std::string::npos);
  EXPECT_EQ(look(65.), "") << "once";
}



TEST(EnergyWatch, stops_where_the_scheme_gives)
{
  EnergyLedger           ledger(false);
  coupling::CoupledState state;
  ledger.update(state);
  state.blocks.energy.gravity                 = -100.;
  state.blocks.energy.kinetic                 = 120.;
  state.blocks.energy.spring_replacement_loss = -20.;
  ledger.update(state);
  EXPECT_LT(ledger.residual(), 1e-12);
  EnergyWatch watch(0.01, 0.05);
  EXPECT_TRUE(watch.is_over(ledger));
  const std::string text = watch.look(ledger, 0.4);
  EXPECT_NE(text.find("gives energy: 9.09 % of the 220 J/m in play"), std::string::npos) << text;
  EXPECT_NE(text.find("contacts give way to others under load"), std::string::npos) << text;
  state.blocks.energy.spring_replacement_loss = 0.;
  state.blocks.energy.integration_loss        = -20.;
  ledger.update(state);
  EXPECT_NE(watch.look(ledger, 0.4).find("smaller Time/Time step may do"), std::string::npos);
}
