// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/statics/great_static_steps.h>
#include <hybrid/dda/step/initial_state.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// A column of eight squares bonded to each other and to the base.
  Model column(const double cohesion)
  {
    scene::SceneParameters p             = block_parameters(30.);
    p.blocks.bonded                      = true;
    p.blocks.belt_material               = "rock";
    p.materials["rock"].cohesion         = cohesion;
    p.materials["rock"].tensile_strength = cohesion;
    scene::SectionMesh mesh              = square_blocks(1, 8);
    mesh.lines["sliding_surface"].push_back({0, 1});
    return build_model(mesh, p, straight_foundation(0., 0., 1., 1));
  }
} // namespace



TEST(GreatStaticSteps, a_mass_is_whole_while_its_joints_hold_it_to_the_ground)
{
  Model    model = column(1e6);
  DdaState state = initial_state(model);
  EXPECT_TRUE(is_whole(model, state));
  state.joints[3].failure = FailureKind::shear;
  EXPECT_FALSE(is_whole(model, state));
  state.joints[3].failure = FailureKind::none;
  // Without its joint the upper part hangs in the air.
  model.joints.erase(model.joints.begin() + 3);
  state.joints.erase(state.joints.begin() + 3);
  EXPECT_FALSE(is_whole(model, state));
}



TEST(GreatStaticSteps, few_iterations_bring_a_whole_mass_to_rest)
{
  const Model  model = static_problem(column(1e6));
  DdaState     state = initial_state(model);
  StaticResult result;
  ASSERT_TRUE(take_great_steps(model, state, {}, result));
  EXPECT_TRUE(result.equilibrium);
  EXPECT_LE(result.iterations, 16);
  EXPECT_NEAR(state.blocks[0].stress[1], -2220. * 9.81 * 7.5, 5e-3 * 2220. * 9.81 * 8.);
}



TEST(GreatStaticSteps, a_mass_that_its_joints_cannot_hold_is_left_as_it_was)
{
  const Model  model = static_problem([] {
    Model tilted      = column(1e3);
    tilted.horizontal = 5.; // its foot cannot bear the moment
    return tilted;
  }());
  DdaState     state = initial_state(model);
  StaticResult result;
  EXPECT_FALSE(take_great_steps(model, state, {}, result));
  EXPECT_FALSE(result.equilibrium);
  EXPECT_EQ(result.steps, 0);
  const DdaState start = initial_state(model);
  for (int b = 0; b < 8; ++b)
    EXPECT_EQ(state.blocks[b].centroid, start.blocks[b].centroid);
  for (const JointState &joint : state.joints)
    EXPECT_EQ(joint.failure, FailureKind::none);
}
