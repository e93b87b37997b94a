// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_stiffness.h"

#include <hybrid/dda/joint/joint_law.h>
#include <hybrid/dda/joint/rock_bond.h>

#include <gtest/gtest.h>

#include <string>

using namespace hybrid;
using namespace hybrid::dda;



// Cracks and slides at once, above all: friction, cohesion and what the damage leaves of it follow
// the gap.
TEST(JointLawTangents, are_the_derivatives_of_the_tractions)
{
  Material m;
  m.cohesion                = 2e4;
  m.tensile_strength        = 1e4;
  m.residual_cohesion       = 5e3;
  m.friction_angle          = 20.; // in tension the strength stays above zero
  m.residual_friction_angle = 15.;
  const JointLaw law(bond_strength(m, 10., 1e-3), k_n, k_s);
  const double   elastic = 1e4 / k_n, h = 1e-5 * elastic;
  JointHistory   softened;
  softened.softening          = 2e-4;
  const JointHistory damaged  = law.respond({4e-5, 0.}, {}).history;
  int                mixed    = 0;
  const auto         is_mixed = [](const JointResponse &r, const JointHistory &old) {
    return r.state == ContactState::sliding && r.history.damage > old.damage;
  };
  for (const JointHistory &old : {JointHistory(), softened, damaged})
    for (const double gap : {-1.3 * elastic, 0.4 * elastic, 1.7 * elastic, 3e-5, 6e-4, 1.7e-3})
      for (const double slip : {-1.7e-3, -2.2e-4, 0.7e-6, 1.1e-4, 1.3e-3})
        for (const double ratio : {0., 3.})
          {
            const auto at = [&](const double g, const double s) {
              return law.respond({g, s}, old, {ratio, 0.9 * gap, 0.});
            };
            const JointResponse r    = at(gap, slip);
            const auto          fall = [h](const double before, const double after) {
              return (before - after) / (2. * h);
            };
            const std::string where = std::to_string(1e6 * gap) + " " + std::to_string(1e6 * slip);
            const JointResponse closer = at(gap - h, slip), wider = at(gap + h, slip);
            EXPECT_NEAR(r.k_nn, fall(closer.normal, wider.normal), 1e-5 * k_n) << where;
            EXPECT_NEAR(r.k_tn, fall(closer.shear, wider.shear), 1e-5 * k_n) << where;
            EXPECT_NEAR(r.shear_by_slip,
                        fall(at(gap, slip - h).shear, at(gap, slip + h).shear),
                        1e-5 * k_s)
              << where;
            mixed += is_mixed(r, old) ? 1 : 0;
          }
  EXPECT_GT(mixed, 20);
}
