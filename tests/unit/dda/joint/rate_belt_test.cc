// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_stiffness.h"

#include <hybrid/dda/joint/belt_bond.h>
#include <hybrid/dda/joint/joint_law.h>
#include <hybrid/dda/joint/rate_belt.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;


  Material clay(const double coefficient)
  {
    Material m;
    m.name                    = "clay";
    m.friction_angle          = 20.;
    m.residual_friction_angle = 12.;
    m.cohesion                = 2e4;
    m.residual_cohesion       = 5e3;
    m.rate_coefficient        = coefficient;
    m.reference_rate          = 1e-4;
    return m;
  }

  JointLaw law_of(const double coefficient)
  {
    return JointLaw(rate_belt().bond(clay(coefficient), 10., 0.02), k_n, k_s);
  }
} // namespace



TEST(RateBelt, without_a_coefficient_it_is_the_belt)
{
  const JointStrength s = rate_belt().bond(clay(0.), 10., 0.02);
  EXPECT_EQ(s.rule, nullptr);
  EXPECT_EQ(s.tan_phi, belt_strength(clay(0.), 10., 0.02).tan_phi);
}



TEST(RateBelt, friction_follows_the_rate_and_never_changes_its_sign)
{
  for (const double a : {0.05, -0.05, -1.})
    for (const double ln : {0., 1., 40.})
      {
        const RateFactor f = rate_factor(a, ln);
        EXPECT_GT(f.value, 0.);
        EXPECT_EQ(f.value == 1., ln == 0.);
        const double h = 1e-6;
        EXPECT_NEAR(f.derivative,
                    (rate_factor(a, ln + h).value - rate_factor(a, ln - h).value) / (2. * h),
                    1e-6 * std::abs(a));
      }
  EXPECT_DOUBLE_EQ(rate_factor(0.02, 5.).value, 1.1);
  EXPECT_DOUBLE_EQ(rate_factor(-0.02, 5.).value, 1. / 1.1);
}



TEST(RateBelt, traction_is_the_strength_at_its_own_rate_with_its_tangents)
{
  for (const double a : {0.03, -0.03})
    for (const double duration : {1e-3, 1., std::numeric_limits<double>::infinity()})
      for (const double slip : {4e-3, -1.5e-2, 0.1})
        {
          const JointLaw      law    = law_of(a);
          const double        normal = k_n * 1e-4;
          const JointResponse r      = law.respond({-1e-4, slip, 1., duration}, {});
          ASSERT_EQ(r.state, ContactState::sliding);
          const double        x      = r.history.softening;
          const JointStrength s      = rate_belt().bond(clay(a), 10., 0.02);
          const double        factor = rate_factor(a, std::log1p(x / duration / 1e-4)).value;
          const double        strength =
            s.residual_cohesion + s.bond_cohesion(x) + normal * s.friction_at(x) * factor;
          EXPECT_NEAR(r.shear, -std::copysign(strength, slip), 1e-9 * strength);
          const double h  = 1e-8;
          const auto   at = [&](const double gap, const double u) {
            return law.respond({gap, u, 1., duration}, {}).shear;
          };
          EXPECT_NEAR(r.shear_by_slip,
                      (at(-1e-4, slip - h) - at(-1e-4, slip + h)) / (2. * h),
                      1e-5 * k_s);
          EXPECT_NEAR(r.k_tn, (at(-1e-4 - h, slip) - at(-1e-4 + h, slip)) / (2. * h), 1e-5 * k_n);
        }
}
