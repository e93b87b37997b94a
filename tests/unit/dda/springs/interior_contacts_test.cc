// SPDX-License-Identifier: GPL-3.0-or-later
#include "spring_scene.h"

#include <hybrid/dda/springs/interior_contacts.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  constexpr double energy = 1e-3; ///< J/m
  constexpr double force  = 1e3;  ///< N/m

  /// Two squares that are held where a motion has brought them.
  struct Held
  {
    SpringScene      scene;
    SpringStiffness  stiffness;
    InteriorContacts path;

    /// Loose ones. @param right, up motion of both [m]
    Held(const double right, const double up)
      : scene(false)
    {
      Eigen::VectorXd d = Eigen::VectorXd::Zero(20);
      d.segment<2>(0) = d.segment<2>(6) = Vec2(right, up);
      begin(d);
    }

    /// Bonded ones, with joints of this strength. @param moved motion of the second [m]
    Held(const JointStrength &strength, const Vec2 &moved)
      : scene(true)
    {
      for (Joint &joint : scene.model.joints)
        joint.law = joint.law.with(strength);
      scene.springs.collect(scene.model, scene.state);
      Eigen::VectorXd d = Eigen::VectorXd::Zero(20);
      d.segment<2>(6)   = moved;
      begin(d);
    }

    void begin(const Eigen::VectorXd &d)
    {
      scene.move(d);
      path.begin(scene.model, scene.springs, scene.trial.dt, energy, force);
    }

    Springs &springs()
    {
      return scene.springs;
    }

    /// Go to the end of the path.
    void follow()
    {
      const Eigen::VectorXd none = Eigen::VectorXd::Zero(20);
      for (int k = 0; k < 22; ++k)
        {
          path.aim(0.1 * path.mean_product(), false);
          path.set_responses(scene.trial, springs());
          stiffness.update(springs(), scene.trial, {});
          path.move(0.9 * path.follow(springs(), stiffness, none));
        }
      path.aim(path.mean_product(), false);
      path.set_responses(scene.trial, springs());
    }
  };
} // namespace



TEST(InteriorContacts, begin_with_equal_products)
{
  Held held(1e-5, -1e-6);
  EXPECT_EQ(held.path.size(), held.springs().springs.size());
  EXPECT_NEAR(held.path.mean_product(), energy, 1e-12 * energy);
}



// Whatever they do, at the end of the path contacts bear what their law says.
TEST(InteriorContacts, end_at_the_law)
{
  struct Case
  {
    double       right, up; ///< [m]
    ContactState state;     ///< of the first contact
  };
  for (const Case &motion : {Case{1e-4, -1e-6, ContactState::sliding},
                             Case{-1e-4, -1e-6, ContactState::sliding},
                             Case{1e-6, -1e-6, ContactState::locked},
                             Case{1e-6, 1e-6, ContactState::open}})
    {
      Held                   held(motion.right, motion.up);
      std::vector<Condition> law, end(held.springs().springs.size(), Condition::law);
      std::vector<Vec2>      traction;
      ASSERT_EQ(held.springs().responses[0].now.state, motion.state);
      for (std::size_t s = 0; s < end.size(); ++s)
        {
          const SpringState &now = held.springs().responses[s].now;
          law.push_back(held.springs().condition(s));
          traction.push_back({now.normal, now.shear});
        }
      held.follow();
      EXPECT_LT(held.path.mean_product(), 1e-7 * energy);
      EXPECT_GT(held.path.conditions(end), 0);
      EXPECT_EQ(held.path.conditions(end), 0);
      for (std::size_t s = 0; s < end.size(); ++s)
        {
          const SpringState &now = held.springs().responses[s].now;
          if (std::abs(now.gap) > 1e-9) // else it is between open and closed
            {
              EXPECT_EQ(end[s], law[s]) << s;
            }
          EXPECT_LT((Vec2(now.normal, now.shear) - traction[s]).norm(), 1e-3 * force) << s;
        }
    }
}



// Likewise joints that hold still, whether they slide, stick or have no strength left beyond the
// apex of the Mohr-Coulomb cone: there the normal force stays, and slip has no direction.
TEST(InteriorContacts, bonds_end_at_the_law)
{
  struct Case
  {
    double       right, up; ///< [m]
    ContactState state;     ///< of the joint's first end
    Condition    end;       ///< likewise, at the end of the path
  };
  JointStrength strength;
  strength.tensile = 1e7; // Pa
  strength.tan_phi = strength.residual_tan_phi = 0.5;
  strength.cohesion                            = 1e5;
  strength.softening_slip                      = 0.1;
  for (const Case &motion : {Case{-1e-5, 2e-4, ContactState::sliding, Condition::slides_backward},
                             Case{-1e-5, -2e-4, ContactState::sliding, Condition::slides_forward},
                             Case{-1e-5, 1e-7, ContactState::locked, Condition::sticks},
                             Case{3e-4, 1e-5, ContactState::sliding, Condition::law}})
    {
      Held held(strength, Vec2(motion.right, motion.up));
      ASSERT_EQ(held.springs().springs[0].joint, 0);
      const SpringState law = held.springs().responses[0].now;
      ASSERT_EQ(law.state, motion.state);
      held.follow();
      const SpringState &end = held.springs().responses[0].now;
      EXPECT_EQ(end.normal, law.normal);
      EXPECT_NEAR(end.shear, law.shear, 1e-3 * force);
      std::vector<Condition> conditions(held.springs().springs.size(), Condition::open);
      held.path.conditions(conditions);
      EXPECT_EQ(conditions[0], motion.end) << motion.right << " " << motion.up;
    }
}



// Each contact goes as far as it can, none farther; common steps end where the first one must stop.
TEST(InteriorContacts, each_goes_as_far_as_it_can)
{
  const Eigen::VectorXd none    = Eigen::VectorXd::Zero(20);
  const auto            product = [&](const bool each) {
    Held held(1e-5, -1e-6);
    held.path.aim(1e-2 * held.path.mean_product(), false);
    held.path.set_responses(held.scene.trial, held.springs());
    held.stiffness.update(held.springs(), held.scene.trial, {});
    const double longest = held.path.follow(held.springs(), held.stiffness, none);
    EXPECT_LT(longest, 0.9);
    if (each)
      held.path.move_each(0.995);
    else
      held.path.move(0.995 * longest);
    return held.path.mean_product();
  };
  EXPECT_GT(product(true), 0.);
  EXPECT_LT(product(true), 0.9 * product(false));
}



// Where a contact slides mu N - T falls far below the round-off of T, and the path goes on.
TEST(InteriorContacts, goes_on_below_round_off)
{
  Held                  held(1e-4, -1e-6);
  const Eigen::VectorXd none  = Eigen::VectorXd::Zero(20);
  const double          begin = held.path.mean_product();
  for (int k = 0; k < 40; ++k)
    {
      held.path.aim(0.1 * held.path.mean_product(), false);
      held.path.set_responses(held.scene.trial, held.springs());
      held.stiffness.update(held.springs(), held.scene.trial, {});
      held.path.follow(held.springs(), held.stiffness, none);
      held.path.move_each(0.995);
    }
  EXPECT_GT(held.path.mean_product(), 0.);
  EXPECT_LT(held.path.mean_product(), 1e-20 * begin);
  for (const Springs::Response &response : held.springs().responses)
    EXPECT_TRUE(std::isfinite(response.now.normal + response.now.shear + response.shear_by_slip));
}



// The stiffness is the derivative of what the eliminated variables add to the forces.
TEST(InteriorContacts, direction_follows_the_motion)
{
  Held held(1e-5, -1e-6);
  held.path.aim(0.1 * energy, false);
  held.path.set_responses(held.scene.trial, held.springs());
  held.stiffness.update(held.springs(), held.scene.trial, {});
  const Springs::Response before = held.springs().responses[0];
  Eigen::VectorXd         down   = Eigen::VectorXd::Zero(20);
  down.segment<2>(0)             = Vec2(1e-9, -1e-9); // small: no factor changes its sign
  const Vec2 jump                = held.stiffness.displacement_jump(held.springs(), 0, down);
  EXPECT_NEAR(std::abs(jump[0]), 1e-9, 1e-13);
  EXPECT_NEAR(std::abs(jump[1]), 1e-9, 1e-13);
  EXPECT_LT(jump[0], 0.); // it closes
  EXPECT_GT(before.k_nn, 0.);
  EXPECT_LT(before.k_nn, held.springs().springs[0].law->normal_stiffness());
  EXPECT_GT(before.shear_by_slip, 0.);
  EXPECT_LT(before.shear_by_slip, held.springs().springs[0].law->shear_stiffness());
}
