// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/failure/joint_failure.h>
#include <hybrid/dda/joint/rock_bond.h>

#include <gtest/gtest.h>

using namespace hybrid;
using namespace hybrid::dda;

namespace
{
  constexpr double length = 4.; // [m]



  Joint bond()
  {
    Material material;
    material.tensile_strength = 1e5;
    material.cohesion         = 1e5;
    material.friction_angle   = 30.;
    return {0, 0, 1, length, {}, JointLaw(bond_strength(material, 0., 0.1), 1e9, 1e9)};
  }



  /// After a step in which one end slid plastically by @p slip and opened to @p gap [m].
  JointState after(const double slip, const double gap, const double time)
  {
    JointState state;
    state.points[1].history.plastic_slip = slip;
    state.points[1].gap                  = gap;
    update_failure(bond(), time, state);
    return state;
  }
} // namespace


TEST(JointFailure, joint_that_has_yielded_wakes_its_blocks_before_it_fails)
{
  EXPECT_FALSE(after(0.009, 0., 1.).has_yielded);
  EXPECT_TRUE(after(-0.011, 0., 1.).has_yielded);
  EXPECT_TRUE(after(0., 0.011, 1.).has_yielded);
  EXPECT_FALSE(after(0., -0.011, 1.).has_yielded) << "squeezed";
  EXPECT_EQ(after(0.011, 0., 1.).failure, FailureKind::none);
}



TEST(JointFailure, joint_of_blocks_that_yield_wakes_them_in_the_static_stage_after_a_tenth)
{
  const auto wakes = [](const double slip, const double time) {
    JointState state;
    state.points[0].history.plastic_slip = slip;
    update_failure(bond(), time, state, true);
    return state.has_yielded;
  };
  EXPECT_FALSE(wakes(0.39, -1.));
  EXPECT_TRUE(wakes(0.41, -1.));
  EXPECT_FALSE(wakes(0.009, 1.));
  EXPECT_TRUE(wakes(0.011, 1.)) << "what flows must not overlap";
}



TEST(JointFailure, belt_that_slides_wakes_nobody)
{
  Joint belt = bond();
  belt.kind  = JointKind::belt;
  JointState state;
  state.points[0].history.plastic_slip = 0.011;
  update_failure(belt, 1., state);
  EXPECT_FALSE(state.has_yielded);
}



TEST(JointFailure, in_the_static_stage_blocks_are_woken_too)
{
  // A corner between joints that yield would sink into the ground unseen.
  EXPECT_TRUE(after(0.011, 0., -1.).has_yielded);
  EXPECT_EQ(after(0.011, 0., -1.).failure, FailureKind::none);
}



TEST(JointFailure, joint_fails_when_both_ends_are_broken_and_is_released_when_far_apart)
{
  JointState state;
  state.points[0].history.softening = 0.2;
  update_failure(bond(), 1., state);
  EXPECT_EQ(state.failure, FailureKind::none);

  state.points[1].history.softening = 0.2;
  update_failure(bond(), 2., state);
  EXPECT_EQ(state.failure, FailureKind::shear);
  EXPECT_EQ(state.failure_time, 2.);
  EXPECT_FALSE(state.released);

  state.points[0].jump = {0.5, 0.};
  update_failure(bond(), 3., state);
  EXPECT_TRUE(state.released);
  EXPECT_EQ(state.failure_time, 2.);
}



// Beside a critical opening of millimetres the bond is open everywhere but at the other end's tip.
TEST(JointFailure, torn_end_that_gapes_ends_the_joint)
{
  JointState state;
  state.points[0].history.damage = 1.;
  state.points[0].gap            = 0.39;
  state.points[0].jump           = {0., 0.39};
  update_failure(bond(), 1., state);
  EXPECT_EQ(state.failure, FailureKind::none);

  state.points[0].jump = {0.6, 0.39}; // the joint slides
  update_failure(bond(), 2., state);
  EXPECT_EQ(state.failure, FailureKind::none);

  state.points[0].gap = 0.41;
  update_failure(bond(), 3., state);
  EXPECT_EQ(state.failure, FailureKind::tensile);
  EXPECT_TRUE(state.released);
}
