// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/failed_joints.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace hybrid;

namespace
{
  /// A joint of these strengths.
  dda::Joint
  joint(const double tensile, const double cohesion, const double tan_phi, const double residual)
  {
    dda::JointStrength strength;
    strength.tensile           = tensile;
    strength.cohesion          = cohesion;
    strength.residual_cohesion = cohesion;
    strength.tan_phi           = tan_phi;
    strength.residual_tan_phi  = residual;
    return {0, 0, 1, 1., {}, dda::JointLaw(strength, 1e9, 1e9)};
  }

  dda::JointState failed(const dda::FailureKind kind, const double time)
  {
    dda::JointState state;
    state.failure      = kind;
    state.failure_time = time;
    return state;
  }
} // namespace



TEST(FailedJoints, are_counted_by_kind_and_stage)
{
  dda::Model    model;
  dda::DdaState state;
  model.joints = {joint(1e3, 0., 0.5, 0.5),
                  joint(0., 0., 0.5, 0.3),
                  joint(0., 0., 0.5, 0.4),
                  joint(0., 1e3, 0.5, 0.5)};
  state.joints = {failed(dda::FailureKind::tensile, 3.),
                  failed(dda::FailureKind::shear, 2.),
                  failed(dda::FailureKind::shear, -1.),
                  dda::JointState()};
  output::Summary summary;
  output::count_failed_joints(model, state, summary);
  EXPECT_EQ(summary.joints.tensile, 1);
  EXPECT_EQ(summary.joints.shear, 1);
  EXPECT_EQ(summary.static_joints.tensile, 0);
  EXPECT_EQ(summary.static_joints.shear, 1);
  EXPECT_EQ(summary.first_failure_time, 2.);
  EXPECT_EQ(summary.first_loss_time, 2.);
}



TEST(FailedJoints, whose_residual_strength_is_their_peak_lose_nothing_by_slip)
{
  dda::Model    model;
  dda::DdaState state;
  model.joints = {joint(0., 0., 0.5, 0.5), joint(0., 1e3, 0.5, 0.5), joint(0., 1e3, 0.5, 0.5)};
  state.joints = {failed(dda::FailureKind::shear, 1.),
                  failed(dda::FailureKind::shear, 2.),
                  failed(dda::FailureKind::tensile, 4.)}; // opening takes the cohesion
  output::Summary summary;
  output::count_failed_joints(model, state, summary);
  EXPECT_EQ(summary.joints.shear, 2);
  EXPECT_EQ(summary.first_failure_time, 1.);
  EXPECT_EQ(summary.first_loss_time, 4.);

  model.joints.push_back(joint(1., 0., 0.5, 0.5)); // a tension that slip takes in the end
  state.joints.push_back(failed(dda::FailureKind::shear, 3.));
  output::count_failed_joints(model, state, summary);
  EXPECT_EQ(summary.first_loss_time, 3.);
}



TEST(FailedJoints, none_leave_the_times_unknown)
{
  dda::Model    model;
  dda::DdaState state;
  model.joints = {joint(1e3, 1e3, 0.5, 0.5)};
  state.joints = {dda::JointState()};
  output::Summary summary;
  output::count_failed_joints(model, state, summary);
  EXPECT_EQ(summary.joints.shear + summary.joints.tensile, 0);
  EXPECT_TRUE(std::isnan(summary.first_failure_time));
  EXPECT_TRUE(std::isnan(summary.first_loss_time));
}
