// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/water_on_bedrock.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::coupling;

  constexpr double unit_weight = 9810.;

  /// 10 m of level ground below a level that rises from 3 to 5 m within 2 s.
  dda::Model level_ground(const dda::Water::Action action)
  {
    dda::Model model;
    model.initial.foundation_nodes = {{0., 0.}, {10., 0.}};
    model.water                    = {action, 3., unit_weight};
    model.water.history =
      std::make_shared<const scene::LinearTable>(scene::LinearTable{{{0., 3.}, {2., 5.}}});
    return model;
  }
} // namespace



TEST(WaterOnBedrock, is_there_where_a_level_changes_and_presses)
{
  dda::Model model = level_ground(dda::Water::Action::pressures);
  EXPECT_NE(WaterOnBedrock::make(model), nullptr);
  model.water.history = nullptr;
  EXPECT_EQ(WaterOnBedrock::make(model), nullptr);
  EXPECT_EQ(WaterOnBedrock::make(level_ground(dda::Water::Action::buoyancy)), nullptr);
}



TEST(WaterOnBedrock, is_what_has_come_since_the_static_state)
{
  WaterOnBedrock        load(level_ground(dda::Water::Action::pressures));
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(4);
  load.begin(0.5, 0.5, none);
  EXPECT_NEAR(load.force()[1], -unit_weight * 5., 1e-6); // 1 m on the half of 10 m
  EXPECT_NEAR(load.force()[3], -unit_weight * 5., 1e-6);
  EXPECT_EQ(load.force()[0], 0.);
  load.begin(-1., 1., none);
  EXPECT_EQ(load.force().norm(), 0.);
}



TEST(WaterOnBedrock, works_with_the_weights_of_newmark)
{
  dda::Model model    = level_ground(dda::Water::Action::pressures);
  model.newmark.gamma = 0.6;
  WaterOnBedrock  load(model);
  Eigen::VectorXd down(4);
  down << 0., -0.25, 0., -0.25;
  const Eigen::VectorXd farther = 2. * down;
  load.begin(0.5, 0.5, down);
  EXPECT_NEAR(load.work(farther), 0.25 * 10. * unit_weight * (0.4 * 0.5 + 0.6 * 1.), 1e-6);
}
