// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/statics/lost_hold.h>
#include <hybrid/dda/statics/static_steps.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// Bonded squares of 1 m in a row, of which the last one hangs over the end of the ground.
  Model overhang(const double tensile_strength)
  {
    scene::SceneParameters p             = block_parameters(30., 1e9);
    p.blocks.bonded                      = true;
    p.materials["rock"].cohesion         = 1e8;
    p.materials["rock"].tensile_strength = tensile_strength;
    return static_problem(build_model(square_blocks(4, 1), p, straight_foundation(0., 1., 3.)));
  }



  double fallen(const Model &model, const DdaState &state, const int block)
  {
    const DdaState drawn = initial_state(model);
    return drawn.blocks[block].centroid.y() - state.blocks[block].centroid.y();
  }
} // namespace



TEST(LostHold, what_breaks_off_stays_where_it_lost_its_hold)
{
  const Model        model = overhang(5e3);
  DdaState           state = initial_state(model);
  const StaticResult found = take_static_steps(model, state);
  EXPECT_FALSE(found.equilibrium);
  EXPECT_LT(found.steps, 200);
  EXPECT_GT(fallen(model, state, 3), 1e-3);
  EXPECT_LT(fallen(model, state, 3), 0.2);
  EXPECT_LT(std::abs(fallen(model, state, 0)), 1e-3);
}



TEST(LostHold, what_holds_is_not_lost)
{
  const Model model = overhang(1e8);
  DdaState    state = initial_state(model);
  EXPECT_TRUE(take_static_steps(model, state).equilibrium);
  EXPECT_LT(std::abs(fallen(model, state, 3)), 1e-2);
}



TEST(LostHold, what_was_drawn_in_the_air_was_never_held)
{
  scene::SectionMesh mesh = square_blocks(1, 1);
  for (Vec2 &x : mesh.nodes)
    x.y() += 0.4;
  const Model model =
    static_problem(build_model(mesh, block_parameters(30., 1e9), straight_foundation(0., 1., 2.)));
  DdaState state = initial_state(model);
  EXPECT_TRUE(take_static_steps(model, state).equilibrium);
  EXPECT_NEAR(fallen(model, state, 0), 0.4, 1e-3);
}



TEST(LostHold, a_fall_counts_from_where_the_block_was_last_held)
{
  const Model model = overhang(1e8);
  DdaState    state = initial_state(model);
  LostHold    hold;
  state.contacts.push_back({0, 0, foundation_body, 0});
  state.contacts.back().state = ContactState::locked;
  EXPECT_FALSE(hold.falls(model, state));
  for (JointState &joint : state.joints)
    joint.released = true;
  const double place = state.blocks[3].centroid.y();
  state.blocks[3].centroid.y() -= 0.04 * model.blocks[3].size;
  EXPECT_FALSE(hold.falls(model, state));
  state.blocks[3].centroid.y() -= 0.5 * model.blocks[3].size;
  EXPECT_TRUE(hold.falls(model, state));
  EXPECT_DOUBLE_EQ(hold.loss().blocks[3].centroid.y(), place - 0.04 * model.blocks[3].size);
}
