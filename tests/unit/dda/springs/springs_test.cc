// SPDX-License-Identifier: GPL-3.0-or-later
#include "spring_scene.h"

#include <hybrid/dda/joint/rock_bond.h>
#include <hybrid/dda/springs/spring_condition.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;
} // namespace



TEST(Springs, every_joint_end_and_every_contact_is_one_spring)
{
  EXPECT_EQ(SpringScene(true).springs.springs.size(), 2u + 4u);
  EXPECT_EQ(SpringScene(false).springs.springs.size(), 5u);
}



TEST(Springs, no_displacement_no_force)
{
  for (const bool bonded : {true, false})
    EXPECT_LT(SpringScene(bonded).forces(Eigen::VectorXd::Zero(20)).norm(),
              1e-5); // N; k is 1e9 N/m
}



TEST(Springs, action_equals_reaction_in_force_and_moment)
{
  for (const bool bonded : {true, false})
    for (const double damping : {0., 0.05})
      {
        SpringScene scene(bonded, damping);
        scene.trial.rate[0] << 0.1, -0.2, 0.3, 0.1, 0.2, 0.1;
        const Eigen::VectorXd f      = scene.forces(pressing(1e-5));
        Vec2                  sum    = Vec2::Zero();
        double                moment = 0.;
        for (int b = 0; b < 2; ++b)
          {
            const Vec2 force = f.segment<2>(6 * b);
            sum += force;
            moment += cross(scene.trial.motion[b].centroid, force) + f[6 * b + 2];
          }
        double largest = 0.;
        for (int k = 0; k < 4; ++k)
          {
            const Vec2 force = f.segment<2>(12 + 2 * k);
            const Vec2 place =
              scene.model.initial.foundation_nodes[k] + scene.trial.foundation.segment<2>(2 * k);
            sum += force;
            moment += cross(place, force);
            largest = std::max(largest, force.norm());
          }
        EXPECT_GT(largest, 1e3);
        EXPECT_LT(sum.norm(), 1e-10 * largest);
        // a contact force acts at the vertex, which is off its segment by the penetration (1e-5 m)
        EXPECT_LT(std::abs(moment), 3e-5 * largest);
      }
}



TEST(Springs, forces_are_the_gradient_of_the_stored_energy)
{
  for (const bool bonded : {true, false})
    {
      SpringScene           scene(bonded);
      const Eigen::VectorXd d = pressing(1e-6), f = scene.forces(d);
      for (int i = 0; i < 20; ++i)
        {
          const double    h    = 1e-8;
          Eigen::VectorXd plus = d, minus = d;
          plus[i] += h;
          minus[i] -= h;
          const double slope = (scene.energy(plus) - scene.energy(minus)) / (2. * h);
          EXPECT_NEAR(f[i], -slope, 1e-4 * f.norm()) << i << (bonded ? " bonded" : " loose");
        }
    }
}



/// A joint that is released leaves its slot to a contact: nothing of a torn bond stays there.
TEST(Springs, what_was_taken_back_from_a_bond_is_forgotten)
{
  for (const bool bonded : {true, false})
    {
      SpringScene           scene(bonded);
      const Eigen::VectorXd f = scene.forces(pressing(1e-5));
      for (Springs::Response &response : scene.springs.responses)
        response.taken_back = {1e6, 1e6};
      EXPECT_EQ(scene.forces(pressing(1e-5)), f);
    }
}



TEST(Springs, damping_resists_the_rate)
{
  SpringScene     scene(true, 0.05);
  Eigen::VectorXd d       = Eigen::VectorXd::Zero(20);
  d[6]                    = 1e-6; // the second block moves away from the first [m]
  const Eigen::VectorXd f = scene.forces(d);
  // k_n (1 + b_K / dt) d on the whole edge: b_K = ratio / (pi f), k_n = 40 E / (2 m)
  const double expected = (40. * 50e6 / 2.) * (1. + 0.05 / (M_PI * 2.) / scene.trial.dt) * 1e-6;
  EXPECT_NEAR(f[6], -expected, 1e-6 * expected);
  EXPECT_NEAR(f[0], expected, 1e-6 * expected);
}



TEST(Springs, rigid_rotation_of_a_bonded_pair_gives_no_force)
{
  SpringScene     scene(true);
  const double    angle = 0.01;
  Eigen::VectorXd d     = Eigen::VectorXd::Zero(20);
  const Vec2      pivot(1., 0.5);
  scene.state.contacts.clear();
  scene.springs.collect(scene.model, scene.state);
  for (int b = 0; b < 2; ++b)
    {
      const Vec2 r = scene.state.blocks[b].centroid - pivot;
      d[6 * b]     = (std::cos(angle) - 1.) * r.x() - std::sin(angle) * r.y();
      d[6 * b + 1] = (std::cos(angle) - 1.) * r.y() + std::sin(angle) * r.x();
      d[6 * b + 2] = angle;
    }
  EXPECT_LT(scene.forces(d).norm(), 1e-5); // N; k is 1e9 N/m
}



TEST(Springs, contacts_do_not_depend_on_the_place_in_the_section)
{
  // Far from the origin the gap keeps its digits: forces differ by the round-off of the places
  // only.
  SpringScene near(false), far(false);
  const Vec2  offset(512., 256.);
  for (Vec2 &x : far.state.geometry.vertices)
    x += offset;
  for (Vec2 &x : far.state.geometry.foundation_nodes)
    x += offset;
  for (BlockState &block : far.state.blocks)
    block.centroid += offset;
  far.springs.collect(far.model, far.state);
  const Eigen::VectorXd a = near.forces(pressing(1e-6)), b = far.forces(pressing(1e-6));
  const Eigen::VectorXd a0 = near.forces(pressing(0.)), b0 = far.forces(pressing(0.));
  EXPECT_LT(((a - a0) - (b - b0)).norm(), 1e-9 * a.norm());
}



TEST(Springs, a_contact_bears_what_its_condition_says)
{
  SpringScene     scene(false);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(20);
  right.segment<2>(0) = right.segment<2>(6) = Vec2(1e-4, -1e-6); // m; tan 85 degrees = 11.4
  scene.move(right);
  const std::size_t      n = scene.springs.springs.size();
  std::vector<Condition> conditions(n);
  for (std::size_t s = 0; s < n; ++s)
    conditions[s] = scene.springs.condition(s);
  const auto       &now    = scene.springs.responses[0].now;
  const auto       &spring = scene.springs.springs[0];
  const SpringState law    = now;
  ASSERT_TRUE(spring.coulomb);
  ASSERT_EQ(law.state, ContactState::sliding);
  EXPECT_FALSE(scene.springs.prescribe(scene.model, scene.state, scene.trial, conditions));
  EXPECT_EQ(now.shear, law.shear);

  const auto prescribe = [&](const Condition condition) {
    conditions[0] = condition;
    scene.springs.evaluate(scene.model, scene.state, scene.trial);
    EXPECT_TRUE(scene.springs.prescribe(scene.model, scene.state, scene.trial, conditions));
  };
  prescribe(Condition::sticks);
  EXPECT_DOUBLE_EQ(now.shear, -spring.law->shear_stiffness() * now.slip);
  EXPECT_GT(now.shear / law.shear, 5.);
  EXPECT_EQ(now.normal, law.normal);
  prescribe(law.shear > 0. ? Condition::slides_backward : Condition::slides_forward);
  EXPECT_DOUBLE_EQ(now.shear, -law.shear);
  EXPECT_EQ(now.normal, law.normal);
  prescribe(Condition::open);
  EXPECT_EQ(now.normal, 0.);
  EXPECT_EQ(now.shear, 0.);
}



TEST(Springs, an_open_contact_that_is_taken_for_closed_pulls)
{
  SpringScene     scene(false);
  Eigen::VectorXd up = Eigen::VectorXd::Zero(20);
  up[1] = up[7] = 1e-6;
  scene.move(up);
  const auto &now = scene.springs.responses[0].now;
  ASSERT_EQ(now.state, ContactState::open);
  ASSERT_EQ(now.normal, 0.);
  std::vector<Condition> conditions(scene.springs.springs.size(), Condition::law);
  conditions[0] = Condition::sticks;
  EXPECT_TRUE(scene.springs.prescribe(scene.model, scene.state, scene.trial, conditions));
  EXPECT_DOUBLE_EQ(now.normal, -scene.springs.springs[0].law->normal_stiffness() * now.gap);
  EXPECT_LT(now.normal, 0.);
}



TEST(Springs, a_joint_sticks_where_it_shall)
{
  SpringScene   scene(true);
  JointStrength soft;
  soft.tensile  = 1e9;
  soft.cohesion = soft.residual_cohesion = 1e3; // Pa: slides from some 1e-6 m on
  for (Joint &joint : scene.model.joints)
    joint.law = joint.law.with(soft);
  scene.state.contacts.clear();
  scene.springs.collect(scene.model, scene.state);
  Eigen::VectorXd up = Eigen::VectorXd::Zero(20); // of the second block, along the joint
  up[7]              = 1e-4;
  scene.move(up);
  const auto  &now     = scene.springs.responses[0].now;
  const double sliding = now.shear;
  ASSERT_EQ(now.state, ContactState::sliding);
  std::vector<Condition> conditions(scene.springs.springs.size(), Condition::slides_forward);
  EXPECT_FALSE(scene.springs.prescribe(scene.model, scene.state, scene.trial, conditions));
  conditions[0] = Condition::sticks;
  EXPECT_TRUE(scene.springs.prescribe(scene.model, scene.state, scene.trial, conditions));
  EXPECT_EQ(now.state, ContactState::locked);
  EXPECT_GT(now.shear / sliding, 5.);
}



// Slip without strength has no direction that could turn round.
TEST(Springs, bonds_that_crack_in_the_trial_hold_if_they_shall)
{
  SpringScene   scene(true);
  JointStrength brittle;
  brittle.tensile  = 1e3;
  brittle.cohesion = 1e3;
  for (Joint &joint : scene.model.joints)
    joint.law = joint.law.with(brittle);
  scene.state.contacts.clear();
  scene.springs.collect(scene.model, scene.state);
  Eigen::VectorXd apart = Eigen::VectorXd::Zero(20); // of the second block, away from the first
  apart[6]              = 1e-4;
  scene.move(apart);
  const auto &now = scene.springs.responses[0].now;
  ASSERT_EQ(now.history.damage, 1.);
  ASSERT_EQ(now.normal, 0.);
  EXPECT_TRUE(scene.springs.hold_bonds(scene.model, scene.state, scene.trial));
  EXPECT_EQ(now.history.damage, 0.);
  EXPECT_NEAR(now.normal,
              -scene.springs.springs[0].law->normal_stiffness() * now.gap,
              1e-12 * std::abs(now.normal));
  EXPECT_FALSE(scene.springs.hold_bonds(scene.model, scene.state, scene.trial));
}



TEST(Springs, what_slides_without_shear_follows_its_law)
{
  SpringState now;
  now.state = ContactState::sliding;
  EXPECT_EQ(condition_of(now), Condition::law);
  now.shear = 1.;
  EXPECT_EQ(condition_of(now), Condition::slides_forward);
  now.shear = -1.;
  EXPECT_EQ(condition_of(now), Condition::slides_backward);
}



// Two blocks on four nodes: while none of a spring's bodies is at work its response stays.
TEST(Springs, only_those_at_work_are_evaluated)
{
  SpringScene scene(false);
  scene.forces(Eigen::VectorXd::Zero(20));
  const auto before = scene.springs.responses;
  scene.springs.narrow({}, {0});
  std::vector<char> at_work(before.size(), 0);
  for (std::size_t k = 0; k < scene.springs.n_at_work(); ++k)
    at_work[scene.springs.at_work(k)] = 1;
  scene.forces(pressing(1e-5));
  int changed = 0;
  for (std::size_t s = 0; s < before.size(); ++s)
    {
      const Springs::Bodies &bodies = scene.springs.bodies[s];
      const bool             has_node =
        bodies.other == foundation_body && (bodies.node[0] == 0 || bodies.node[1] == 0);
      EXPECT_EQ(at_work[s] != 0, has_node) << s;
      const bool same = scene.springs.responses[s].now.gap == before[s].now.gap;
      EXPECT_TRUE(same || has_node) << s;
      changed += same ? 0 : 1;
    }
  EXPECT_GT(changed, 0);
  EXPECT_LT(changed, static_cast<int>(before.size()));
  scene.springs.widen();
  EXPECT_EQ(scene.springs.n_at_work(), before.size());
}
