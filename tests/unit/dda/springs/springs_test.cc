// SPDX-License-Identifier: GPL-3.0-or-later
#include "spring_scene.h"

#include <hybrid/dda/joint/rock_bond.h>

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



namespace
{
  /// Move blocks so far, one way and the other, that the first spring slides.
  void slide_there_and_back(SpringScene           &scene,
                            const Eigen::VectorXd &there,
                            const Eigen::VectorXd &back)
  {
    using Reversed  = Springs::SlipReversal;
    const auto &now = scene.springs.responses[0].now;

    scene.move(there, Reversed::locks);
    EXPECT_EQ(now.state, ContactState::sliding);
    EXPECT_FALSE(scene.springs.responses[0].held);
    scene.springs.remember();
    scene.move(back, Reversed::locks);
    EXPECT_EQ(now.state, ContactState::locked);
    EXPECT_TRUE(scene.springs.any_held());
    const double held = now.shear;
    scene.springs.remember();
    scene.move(back, Reversed::locks); // from sticking it may slide either way
    EXPECT_EQ(now.state, ContactState::sliding);
    EXPECT_FALSE(scene.springs.responses[0].held);
    EXPECT_GT(held / now.shear, 5.);

    scene.move(there);
    EXPECT_EQ(now.state, ContactState::sliding);
    EXPECT_FALSE(scene.springs.any_held());
  }
} // namespace



TEST(Springs, a_contact_that_slides_back_sticks_first)
{
  SpringScene     scene(false);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(20), left = right;
  right.segment<2>(0) = right.segment<2>(6) = Vec2(1e-4, -1e-6); // m; tan 85 degrees = 11.4
  left.segment<2>(0) = left.segment<2>(6) = Vec2(-1e-4, -1e-6);
  slide_there_and_back(scene, right, left);
}



TEST(Springs, a_joint_that_slides_back_sticks_first)
{
  SpringScene   scene(true);
  JointStrength soft;
  soft.tensile  = 1e9;
  soft.cohesion = soft.residual_cohesion = 1e3; // Pa: slides from some 1e-6 m on
  for (Joint &joint : scene.model.joints)
    joint.law = joint.law.with(soft);
  scene.state.contacts.clear();
  scene.springs.collect(scene.model, scene.state);
  Eigen::VectorXd up = Eigen::VectorXd::Zero(20), down = up; // of the second block, along the joint
  up[7]   = 1e-4;
  down[7] = -1e-4;
  slide_there_and_back(scene, up, down);
}



// Contacts that slid one way in the trial that was kept stay where they are when they would slide
// back, however often that trial is evaluated.
TEST(Springs, equal_trials_have_equal_forces)
{
  SpringScene scene(false);
  Material    slippery;
  slippery.friction_angle = 5.;
  for (std::vector<ContactLaw> &of_surface : scene.model.contacts.of)
    for (ContactLaw &contact : of_surface)
      contact.law = JointLaw(contact_strength(slippery), 1e9, 1e9);
  scene.springs.collect(scene.model, scene.state);
  Eigen::VectorXd there = pressing(1e-6), back = there;
  there[0] = 1e-4;
  back[0]  = -1e-4;
  scene.move(there);
  scene.springs.remember();
  Eigen::VectorXd forces[3];
  for (Eigen::VectorXd &f : forces)
    {
      scene.move(back, Springs::SlipReversal::locks);
      EXPECT_TRUE(scene.springs.any_held());
      f                        = Eigen::VectorXd::Zero(20);
      Eigen::VectorXd absolute = Eigen::VectorXd::Zero(2);
      scene.springs.add_forces(f, f, absolute);
    }
  EXPECT_EQ(forces[0], forces[1]);
  EXPECT_EQ(forces[0], forces[2]);
}
