// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/output/blocks_off_base.h>

#include <gtest/gtest.h>

using namespace hybrid;



TEST(BlocksOffBase, counts_those_that_have_come_beyond_an_end)
{
  // Three blocks of 2 m from x = 0 on, a base from x = -1 to x = 5.5: the third leans over nothing.
  const dda::Model model = dda::build_model(test::square_blocks(3, 1, 2.),
                                            test::block_parameters(30.),
                                            test::straight_foundation(0., 1., 5.5, 7));
  dda::DdaState    state = dda::initial_state(model);
  EXPECT_EQ(output::blocks_off_base(model, state), 0);
  state.blocks[2].centroid.x() = 5.4;
  EXPECT_EQ(output::blocks_off_base(model, state), 0);
  state.blocks[2].centroid = Vec2(5.6, -30.);
  EXPECT_EQ(output::blocks_off_base(model, state), 1);
  state.blocks[0].centroid.x() = -1.1;
  EXPECT_EQ(output::blocks_off_base(model, state), 2);
  for (int k = 0; k < model.n_foundation_nodes(); ++k) // the base has moved, too
    state.foundation_displacement[2 * k] = -0.2;
  EXPECT_EQ(output::blocks_off_base(model, state), 1);
}



TEST(BlocksOffBase, are_not_those_that_were_drawn_beyond_it)
{
  // The third block is drawn with its centroid beyond the end.
  const dda::Model model       = dda::build_model(test::square_blocks(3, 1, 2.),
                                            test::block_parameters(30.),
                                            test::straight_foundation(0., 1., 4.5, 7));
  dda::DdaState    state       = dda::initial_state(model);
  state.blocks[2].centroid.x() = 5.2;
  EXPECT_EQ(output::blocks_off_base(model, state), 0);
}



TEST(BlocksOffBase, need_a_base)
{
  const dda::Model model =
    dda::build_model(test::square_blocks(1, 1, 2.), test::block_parameters(30.), {});
  const dda::DdaState state = dda::initial_state(model);
  EXPECT_EQ(output::blocks_off_base(model, state), 0);
}



TEST(BlocksOffSurface, are_those_that_lay_on_it_and_touch_it_no_more)
{
  // Two rows of two: the upper ones never lay on it.
  const dda::Model model = dda::build_model(test::square_blocks(2, 2, 2.),
                                            test::block_parameters(30.),
                                            test::straight_foundation(0., 1., 6., 7));
  dda::DdaState    state = dda::initial_state(model);
  state.contacts = {{0, 0, dda::foundation_body, 1}, {1, 4, dda::foundation_body, 3}, {1, 4, 0, 1}};
  EXPECT_EQ(output::blocks_off_surface(model, state), 2); // open
  state.contacts[1].state = state.contacts[2].state = dda::ContactState::sliding;
  EXPECT_EQ(output::blocks_off_surface(model, state), 1);
  state.contacts[0].state = dda::ContactState::locked;
  EXPECT_EQ(output::blocks_off_surface(model, state), 0);
}
