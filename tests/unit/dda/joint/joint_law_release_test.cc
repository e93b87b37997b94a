// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_stiffness.h"

#include <hybrid/dda/joint/joint_law.h>
#include <hybrid/dda/joint/rock_bond.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  constexpr double tension = 1e4, cohesion = 2e4, gap = tension / k_n; // Pa, Pa, m
  const double     tan_phi = std::tan(M_PI / 6.);

  /// Tensile fracture energy 0; slip takes nothing.
  JointLaw brittle()
  {
    Material m;
    m.friction_angle    = 30.;
    m.cohesion          = cohesion;
    m.tensile_strength  = tension;
    m.residual_cohesion = 0.;
    return {bond_strength(m, 0., std::numeric_limits<double>::infinity()), k_n, k_s};
  }
} // namespace



TEST(JointLawRelease, a_brittle_bond_lets_go_over_its_release_time)
{
  const JointLaw law = brittle().letting_go_in(8e-3);
  EXPECT_EQ(brittle().respond({1.1 * gap, 0., 1., 1e-3}, {}).normal, 0.);
  EXPECT_EQ(law.respond({1.1 * gap, 0.}, {}).normal, 0.); // a step without end

  JointHistory history;
  for (int step = 1; step <= 9; ++step)
    {
      const double        left = std::max(0., 1. - step / 8.);
      const JointResponse r    = law.respond({(1. + 0.1 * step) * gap, 1., 1., 1e-3}, history);
      EXPECT_NEAR(-r.normal, left * tension, 1e-9 * tension);
      EXPECT_NEAR(-r.shear, left * (cohesion - tension * tan_phi), 1e-9 * cohesion);
      EXPECT_EQ(r.k_nn, 0.);
      EXPECT_TRUE(law.broken_in_tension(r.history));
      EXPECT_EQ(law.has_let_go(r.history), step >= 8);
      history = r.history;
    }
  EXPECT_EQ(law.respond({0.5 * gap, 0., 1., 1e-3}, history).normal, 0.);
}



// Held by its release in one step, by its softening in the next: neither traction nor strength
// knows.
TEST(JointLawRelease, takes_over_from_softening_without_a_jump)
{
  Material m;
  m.friction_angle    = 30.;
  m.cohesion          = cohesion;
  m.tensile_strength  = tension;
  m.residual_cohesion = 0.;
  const JointLaw law =
    JointLaw(bond_strength(m, 5. * tension * gap, std::numeric_limits<double>::infinity()),
             k_n,
             k_s)
      .letting_go_in(1e-2);
  const double       critical = 10. * gap;
  const JointHistory cracked  = law.respond({2. * gap, 0., 1., 1e-6}, {}).history;
  ASSERT_GT(cracked.held, 0.);
  constexpr int steps   = 4000;
  bool          is_held = false, softens = false;
  JointResponse before = law.respond({2. * gap, 1., 1., 5e-3}, cracked);
  for (int k = 1; k <= steps; ++k)
    {
      const double        open = 2. * gap + k * (0.9 * critical - 2. * gap) / steps;
      const JointResponse now  = law.respond({open, 1., 1., 5e-3}, cracked);
      EXPECT_NEAR(now.normal, before.normal, 1e-3 * tension) << open / gap;
      EXPECT_NEAR(now.shear, before.shear, 1e-3 * cohesion) << open / gap;
      (now.history.held > 0. ? is_held : softens) = true;
      before                                      = now;
    }
  EXPECT_TRUE(is_held);
  EXPECT_TRUE(softens);
}



TEST(JointLawRelease, a_bond_that_lets_go_closes_and_opens_within_what_it_holds)
{
  const JointLaw      law  = brittle().letting_go_in(1.);
  const JointHistory  torn = law.respond({1.1 * gap, 0., 1., 0.1}, {}).history;
  const JointResponse back = law.respond({0.5 * gap, 0., 1., 0.1}, torn);
  EXPECT_NEAR(back.normal, -0.5 * tension, 1e-9 * tension);
  EXPECT_EQ(back.k_nn, k_n);
  const JointResponse closed = law.respond({-gap, 0., 1., 0.1}, back.history);
  EXPECT_NEAR(closed.normal, tension, 1e-9 * tension);
  const JointResponse open = law.respond({gap, 0., 1., 0.1}, closed.history);
  EXPECT_NEAR(open.normal, -0.6 * tension, 1e-9 * tension);
}
