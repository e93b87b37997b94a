// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/moving_blocks.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include "block_scenes.h"

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  /// Three squares of 2 m in a row; the first two are set in motion.
  struct Scene
  {
    scene::SectionMesh     mesh       = test::square_blocks(3, 1, 2.);
    scene::SceneParameters parameters = test::block_parameters(30.);

    Scene()
    {
      parameters.blocks.initial_velocities = {
        {"pair", Vec2(0., 0.), Vec2(3.5, 2.), Vec2(3., -1.), 0.5}};
    }

    Model model() const
    {
      return build_model(mesh, parameters, {});
    }
  };
} // namespace



TEST(InitialVelocities, blocks_of_a_box_move_as_one_body)
{
  const Model model = Scene().model();
  ASSERT_EQ(model.moving_blocks.size(), 1u);
  EXPECT_EQ(model.moving_blocks[0].blocks, (std::vector<int>{0, 1}));
  DdaState   state  = initial_state(model);
  const auto before = state.geometry.vertices;
  set_in_motion(model, state);
  EXPECT_EQ(state.geometry.vertices, before);
  // Centres at (1, 1) and (3, 1), the axis at (2, 1).
  Vec6 first, second;
  first << 3., -1.5, 0.5, 0., 0., 0.;
  second << 3., -0.5, 0.5, 0., 0., 0.;
  EXPECT_EQ(state.blocks[0].velocity, first);
  EXPECT_EQ(state.blocks[1].velocity, second);
  EXPECT_EQ(state.blocks[2].velocity, Vec6::Zero().eval());
  const double mass = 4. * 2220., inertia = mass * 8. / 12.;
  EXPECT_NEAR(state.energy.kinetic,
              0.5 * mass * (first.head<2>().squaredNorm() + second.head<2>().squaredNorm()) +
                inertia * 0.25,
              1e-8);
}



TEST(InitialVelocities, heavier_blocks_draw_the_axis_to_them)
{
  Model model          = Scene().model();
  model.blocks[0].mass = 3. * model.blocks[1].mass;
  DdaState state       = initial_state(model);
  set_in_motion(model, state);
  EXPECT_NEAR(state.blocks[0].velocity[1], -1. - 0.5 * 0.5, 1e-14);
  EXPECT_NEAR(state.blocks[1].velocity[1], -1. + 1.5 * 0.5, 1e-14);
}



TEST(InitialVelocities, nothing_changes_without_them)
{
  Scene scene;
  scene.parameters.blocks.initial_velocities.clear();
  const Model model    = scene.model();
  DdaState    state    = initial_state(model);
  state.energy.kinetic = 1.; // as it was
  set_in_motion(model, state);
  for (const BlockState &block : state.blocks)
    EXPECT_EQ(block.velocity, Vec6::Zero().eval());
  EXPECT_EQ(state.energy.kinetic, 1.);
}



TEST(InitialVelocities, box_without_block_and_block_in_two_boxes_are_refused)
{
  Scene scene;
  auto &boxes = scene.parameters.blocks.initial_velocities;
  boxes.push_back({"last", Vec2(3.5, 0.), Vec2(6., 2.), Vec2(0., 0.), 1.});
  EXPECT_EQ(scene.model().moving_blocks.size(), 2u);
  boxes[1].lower = Vec2(2.5, 0.);
  EXPECT_THROW(scene.model(), InputError);
  boxes[1].lower = Vec2(5.5, 0.);
  EXPECT_THROW(scene.model(), InputError);
}
