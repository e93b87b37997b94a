// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/column_joints.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double k_n = 4e8, k_s = 1e8; // [Pa/m]
  constexpr double soft = 3e-9;          // a side of the joint gives way by this [m per Pa]

  /// Two elements of degree 1 with a joint between them, each of whose sides yields on its own.
  struct Column
  {
    ColumnJoints           joints;
    ColumnJoints::Response response;
    ColumnJoints::Nodal    u;

    explicit Column(const Vec2                         &tangent,
                    const std::optional<PlaneStrength> &strength = std::nullopt)
      : joints({{{1, tangent, 0}}, {k_n, k_s}, strength}, 1)
    {
      for (int c = 0; c < 2; ++c)
        {
          u[c] = Eigen::VectorXd::Zero(4);
          joints.pull_apart(0, u[c]);
          response.motion[c] = soft * u[c];
          u[c].setZero();
        }
      joints.find_relaxation(0., response);
    }

    /// The upper side against the lower one.
    Vec2 jump() const
    {
      return {u[0][2] - u[0][1], u[1][2] - u[1][1]};
    }

    /// What the joint bears, from the way by which its upper side gave way after (x, y) [Pa].
    Vec2 borne(const Vec2 &above) const
    {
      return (above - Vec2(u[0][2], u[1][2])) / soft;
    }

    /// Without the joint the upper side is at (x, y).
    void move(const Vec2 &above)
    {
      for (int c = 0; c < 2; ++c)
        {
          u[c].setZero();
          u[c][2] = above[c];
        }
    }
  };
} // namespace



TEST(ColumnJoints, a_node_more_for_each_joint)
{
  const ColumnJoints joints({{{1}, {3}}, {k_n, k_s}, std::nullopt}, 2);
  EXPECT_EQ(joints.below(0), 0);
  EXPECT_EQ(joints.below(1), 1);
  EXPECT_EQ(joints.below(2), 1);
  EXPECT_EQ(joints.below(3), 2);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(11);
  joints.pull_apart(1, force);
  EXPECT_EQ(force[8], 1.); // the first node of the fourth element: 3 x 2, and two joints
  EXPECT_EQ(force[7], -1.);
  EXPECT_EQ(force.lpNorm<1>(), 2.);
}



TEST(ColumnJoints, an_elastic_joint_bears_its_springs_times_its_jump)
{
  for (const double angle : {0., 0.3, -0.5})
    {
      const Vec2 tangent(std::cos(angle), std::sin(angle)), normal(-tangent.y(), tangent.x());
      Column     column(tangent);
      const Vec2 above(2e-4, 7e-4);
      column.move(above);
      ASSERT_TRUE(column.joints.join(column.response, nullptr, nullptr, column.u));
      // Of a unit width the plane has the length 1 / cos.
      const Vec2 j = column.jump();
      const Vec2 expected =
        (k_n * j.dot(normal) * normal + k_s * j.dot(tangent) * tangent) / std::cos(angle);
      EXPECT_NEAR(column.borne(above).x(), expected.x(), 1e-6);
      EXPECT_NEAR(column.borne(above).y(), expected.y(), 1e-6);
      EXPECT_NEAR(column.u[0][1], above.x() - column.u[0][2], 1e-15); // the lower side likewise
    }
}



TEST(ColumnJoints, explicit_forces_are_those_of_the_springs)
{
  const double angle = 0.4;
  const Vec2   tangent(std::cos(angle), std::sin(angle)), normal(-tangent.y(), tangent.x());
  Column       column(tangent);
  column.move(2e-4 * tangent + 5e-4 * normal);
  ColumnJoints::Nodal force{Eigen::VectorXd::Zero(4), Eigen::VectorXd::Zero(4)};
  column.joints.add_forces(column.u, force);
  const Vec2 expected = (5e-4 * k_n * normal + 2e-4 * k_s * tangent) / std::cos(angle);
  for (int c = 0; c < 2; ++c)
    {
      EXPECT_NEAR(force[c][2], -expected[c], 1e-6);
      EXPECT_NEAR(force[c][1], expected[c], 1e-6);
    }
}



TEST(ColumnJoints, slack_is_where_a_joint_bears_nothing)
{
  Column column({1., 0.});
  column.move({2e-4, 7e-4});
  const ColumnJoints::Nodal slack = column.u;
  ASSERT_TRUE(column.joints.join(column.response, &slack, nullptr, column.u));
  EXPECT_EQ(column.jump(), Vec2(2e-4, 7e-4));
}



TEST(ColumnJoints, slips_at_its_strength_and_keeps_what_it_slipped)
{
  const double tan_phi = 0.5, cohesion = 2e3, compression = 1e4;
  Column       column({1., 0.}, PlaneStrength{tan_phi, cohesion, 0.});
  column.joints.set_rest({-compression, 0.}, {0});
  SlipState state = column.joints.initial_state();
  for (const double way : {1e-3, -1e-3}) // there and back
    {
      const double sign = way > 0. ? 1. : -1.;
      column.move({way, 0.});
      ASSERT_TRUE(column.joints.join(column.response, nullptr, &state, column.u));
      EXPECT_NEAR(column.borne({way, 0.}).x(), sign * (cohesion + tan_phi * compression), 1e-6);
      const SlipState before = state;
      column.joints.keep(state);
      EXPECT_EQ(state.condition[0], PlaneCondition::slipping);
      EXPECT_GT(sign * (state.jump[1] - before.jump[1]), 1e-4);
      EXPECT_DOUBLE_EQ(state.path[0], before.path[0] + std::abs(state.jump[1] - before.jump[1]));
    }
  const SlipState kept = state;
  column.move({kept.jump[1], 0.}); // where it bears nothing
  ASSERT_TRUE(column.joints.join(column.response, nullptr, &state, column.u));
  column.joints.keep(state);
  EXPECT_EQ(state.jump, kept.jump);
  EXPECT_NEAR(column.borne({kept.jump[1], 0.}).x(), 0., 1e-6);
}



TEST(ColumnJoints, opens_and_then_has_friction_only)
{
  const double tan_phi = 0.5, compression = 1e4;
  Column       column({1., 0.}, PlaneStrength{tan_phi, 2e4, 1e3});
  column.joints.set_rest({-compression, 0.}, {0});
  SlipState state = column.joints.initial_state();
  column.move({0., 1e-3});
  ASSERT_TRUE(column.joints.join(column.response, nullptr, &state, column.u));
  EXPECT_NEAR(column.borne({0., 1e-3}).y(), compression, 1e-6); // what it bore at rest
  column.joints.keep(state);
  EXPECT_EQ(state.condition[0], PlaneCondition::open);
  EXPECT_EQ(state.failed[0], 1);
  EXPECT_GT(state.jump[0], 1e-4);
  column.move({1e-3, 0.});
  ASSERT_TRUE(column.joints.join(column.response, nullptr, &state, column.u));
  EXPECT_NEAR(column.borne({1e-3, 0.}).x(), tan_phi * compression, 1e-6);
  column.joints.keep(state);
  EXPECT_EQ(state.jump[0], 0.);
}



TEST(ColumnJoints, what_failed_at_rest_has_no_cohesion)
{
  Column column({1., 0.}, PlaneStrength{0.5, 2e4, 1e3});
  column.joints.set_rest({-1e4, 0.}, {1});
  const SlipState state = column.joints.initial_state();
  column.move({1e-3, 0.});
  ASSERT_TRUE(column.joints.join(column.response, nullptr, &state, column.u));
  EXPECT_NEAR(column.borne({1e-3, 0.}).x(), 5e3, 1e-6);
}
