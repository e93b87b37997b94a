// SPDX-License-Identifier: GPL-3.0-or-later
// A belt: an old sliding surface, whose residual strength is its peak unless it is set, and whose
// cohesion is gone for good where it has opened.
#include "joint_stiffness.h"

#include <hybrid/dda/joint/belt_bond.h>
#include <hybrid/dda/joint/joint_law.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;


  /// A belt whose residual strength nobody has set.
  Material old_belt()
  {
    Material m;
    m.name             = "belt";
    m.friction_angle   = 30.;
    m.cohesion         = 2e4;
    m.tensile_strength = 1e4;
    return m;
  }

  double tan_deg(const double angle)
  {
    return std::tan(angle * M_PI / 180.);
  }
} // namespace



TEST(BeltLaw, belt_falls_to_the_residual_strength_that_is_set)
{
  // Two values that are set, one of the two, none: what is not set is as the peak.
  for (const bool sets_cohesion : {true, false})
    for (const bool sets_friction : {true, false})
      {
        Material m                = old_belt();
        m.residual_cohesion       = sets_cohesion ? 0. : m.residual_cohesion;
        m.residual_friction_angle = sets_friction ? 8. : m.residual_friction_angle;
        const JointLaw law(belt_strength(m, 10., 1e-3), k_n, k_s);
        const double   normal = k_n * 1e-5;
        const double   expected =
          (sets_cohesion ? 0. : 2e4) + normal * tan_deg(sets_friction ? 8. : 30.);
        EXPECT_NEAR(-law.respond({-1e-5, 1e-2}, {}).shear, expected, 1e-6);
        const JointLaw contact(broken_belt_strength(m), k_n, k_s);
        EXPECT_NEAR(-contact.respond({-1e-5, 1e-2}, {}).shear, expected, 1e-6);
        EXPECT_NEAR(-contact.respond({-1e-5, 1e-2, 0.}, {}).shear,
                    normal * tan_deg(sets_friction ? 8. : 30.),
                    1e-6);
      }
}



TEST(BeltLaw, belt_that_has_opened_has_lost_its_cohesion_for_good)
{
  for (const double fracture_energy : {10., 0.})
    {
      const JointLaw     law(belt_strength(old_belt(), fracture_energy, 1e-3), k_n, k_s);
      const JointHistory open = law.respond({3e-3, 0.}, {}).history;
      EXPECT_TRUE(law.broken_in_tension(open));
      const double friction = k_n * 1e-5 * tan_deg(30.);
      EXPECT_NEAR(-law.respond({-1e-5, 1e-2}, open).shear, friction, 1e-6);
      EXPECT_EQ(law.respond({1e-7, 1e-2}, open).state, ContactState::open);
    }
}



TEST(BeltLaw, cohesion_that_a_belt_has_lost_by_opening_partly_does_not_come_back)
{
  const JointLaw law(belt_strength(old_belt(), 10., 1e-3), k_n, k_s);
  // F_t / k_n = 5e-6 m, g_c = 2e-3 m: half way the half is left, at any smaller opening
  const double        half = 0.5 * (5e-6 + 2e-3), h = 1e-9;
  const JointResponse opening = law.respond({half, 0.1}, {});
  const double        tension = 0.5e4 * tan_deg(30.);
  EXPECT_NEAR(-opening.shear, 1e4 - tension, 1.);
  JointHistory then = opening.history;
  then.plastic_slip = 0.;
  EXPECT_NEAR(-law.respond({-1e-5, 0.1}, then).shear, 1e4 + 2e4 * tan_deg(30.), 1.);
  EXPECT_NEAR(-law.respond({half, 0.1}, then).shear, 1e4 - tension, 1.);
  // the tangent is that of what is returned, on both ways
  for (const double gap : {0.5 * half, 1.2 * half})
    {
      const JointResponse r     = law.respond({gap, 0.1}, then),
                          ahead = law.respond({gap + h, 0.1}, then);
      EXPECT_NEAR(r.k_tn, -(ahead.shear - r.shear) / h, 1e-4 * k_n);
    }
}



TEST(BeltLaw, friction_counts_the_normal_traction_that_acts)
{
  Material m         = old_belt();
  m.cohesion         = 0.;
  m.tensile_strength = 0.;
  const JointLaw law(belt_strength(m, 0., 0.), k_n, k_s);
  for (const double change : {-3e-6, -1e-6, 0., 1e-6, 3e-6}) // closes or opens in the step [m]
    for (const double slip : {-1e-3, 1e-3})
      {
        const JointDamping  damping{0.8, -1e-5 - change, 0.};
        const JointResponse r = law.respond({-1e-5, slip}, {}, damping);
        EXPECT_NEAR(r.normal, k_n * (1e-5 - 0.8 * change), 1e-6);
        EXPECT_NEAR(std::abs(r.shear), r.normal * tan_deg(30.), 1e-6) << change;
        const double        h     = 1e-9;
        const JointResponse after = law.respond({-1e-5 + h, slip}, {}, damping);
        EXPECT_NEAR(r.k_tn, (r.shear - after.shear) / h, 1e-4 * k_n) << change;
      }
}
