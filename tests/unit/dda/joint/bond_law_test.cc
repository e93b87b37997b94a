// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_stiffness.h"

#include <hybrid/dda/joint/belt_bond.h>
#include <hybrid/dda/joint/joint_law.h>
#include <hybrid/dda/joint/rock_bond.h>
#include <hybrid/scene/input_error.h>

#include "block_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  constexpr double direct = 0.02, reference = 1e-3; // -, m/s
  constexpr double decay = 5e-3;                    // m

  // The recipe of the developer guide. Friction grows with the logarithm of the rate, and cohesion
  // decays with the slip.
  SoftenedStrength rate_and_decay(const JointStrength &s, const PlasticSlip &slip)
  {
    const double rate = slip.added / slip.duration / reference;
    const double left = std::exp(-(slip.before + slip.added) / decay);
    return {s.tan_phi + direct * std::log1p(rate),
            s.cohesion * left,
            direct / (1. + rate) / (slip.duration * reference),
            -s.cohesion * left / decay};
  }

  JointStrength rate_strength(const Material &material, const double, const double)
  {
    JointStrength s     = belt_strength(material, 0., 1.);
    s.residual_cohesion = 0.;
    s.rule              = rate_and_decay;
    return s;
  }

  JointStrength rate_contact(const Material &material)
  {
    JointStrength s = contact_strength(material);
    s.cohesion      = 0.;
    s.rule          = rate_and_decay;
    return s;
  }

  BondLaw rate_bond()
  {
    return {"rate", rate_strength, rate_contact};
  }

  Material clay()
  {
    Material m;
    m.name              = "clay";
    m.friction_angle    = 20.;
    m.cohesion          = 2e4;
    m.residual_cohesion = 0.;
    return m;
  }
} // namespace



TEST(BondLaw, another_one_is_a_file_and_a_line)
{
  std::vector<BondLaw> laws = bond_laws();
  laws.push_back(rate_bond());
  scene::SceneParameters p      = test::block_parameters(20.);
  p.materials["rock"].cohesion  = 2e4;
  p.blocks.belt_material        = "rock";
  p.bedrock                     = {"rigid", "none"};
  scene::SectionMesh mesh       = test::square_blocks(1, 1);
  mesh.lines["sliding_surface"] = {{0, 1}};
  const BondLaws          bonds = choose_bonds("bond", "rate", laws);
  const std::vector<Vec2> base  = {mesh.nodes[0], mesh.nodes[1]};
  const Model             model = build_model(mesh, p, base, bonds);
  ASSERT_EQ(model.joints.size(), 1u);
  ASSERT_EQ(model.joints[0].kind, JointKind::belt);

  // Both the joint and the contact after it follow the rate, those of the program do not.
  const auto gain = [](const JointLaw &law) {
    const auto shear = [&](const double duration) {
      return std::abs(law.respond({-1e-4, 0.1, 1., duration}, {}).shear);
    };
    return shear(1e-3) / shear(1e9) - 1.;
  };
  const Model usual = build_model(mesh, p, base);
  EXPECT_GT(gain(model.joints[0].law), 0.3);
  EXPECT_EQ(gain(usual.joints[0].law), 0.);
  const auto contact_on_belt = [](const Model &m) {
    return m.contacts.of[m.contacts.segment[0]][0].law;
  };
  EXPECT_GT(gain(contact_on_belt(model)), 0.3);
  EXPECT_EQ(gain(contact_on_belt(usual)), 0.);
}



TEST(BondLaw, a_rule_holds_where_it_slides)
{
  const JointLaw law(rate_strength(clay(), 0., 0.), k_n, k_s);
  const double   normal = k_n * 1e-4;
  for (const double slip : {1e-3, 5e-3, -2e-2})
    for (const double duration : {1e-3, 1., std::numeric_limits<double>::infinity()})
      {
        const JointResponse r = law.respond({-1e-4, slip, 1., duration}, {});
        ASSERT_EQ(r.state, ContactState::sliding);
        const double x = r.history.softening;
        EXPECT_NEAR(x, std::abs(r.history.plastic_slip), 1e-12 * x);
        const SoftenedStrength there =
          rate_and_decay(rate_strength(clay(), 0., 0.), {0., x, duration});
        const double strength = there.cohesion + normal * there.tan_phi;
        EXPECT_NEAR(r.shear, -std::copysign(strength, slip), 1e-9 * strength);
        // the tangents are the derivatives of what is returned
        const double h  = 1e-8;
        const auto   at = [&](const double gap, const double s) {
          return law.respond({gap, s, 1., duration}, {}).shear;
        };
        EXPECT_NEAR(r.shear_by_slip,
                    (at(-1e-4, slip - h) - at(-1e-4, slip + h)) / (2. * h),
                    1e-5 * k_s);
        EXPECT_NEAR(r.k_tn, (at(-1e-4 - h, slip) - at(-1e-4 + h, slip)) / (2. * h), 1e-5 * k_n);
      }
}



TEST(BondLaw, a_rule_that_is_linear_softening_is_the_closed_form)
{
  Material m                = clay();
  m.residual_friction_angle = 8.;
  JointStrength  strength   = bond_strength(m, 0., 0.02);
  const JointLaw closed(strength, k_n, k_s);
  strength.rule = [](const JointStrength &s, const PlasticSlip &slip) -> SoftenedStrength {
    const double kappa = slip.before + slip.added;
    const double fall  = kappa < s.softening_slip ? 1. / s.softening_slip : 0.;
    return {s.friction_at(kappa),
            s.bond_cohesion(kappa),
            (s.residual_tan_phi - s.tan_phi) * fall,
            (s.residual_cohesion - s.cohesion) * fall};
  };
  const JointLaw ruled(strength, k_n, k_s);
  JointHistory   a, b;
  for (int k = 1; k <= 40; ++k)
    {
      const JointKinematics at{-1e-4 - 1e-6 * k, (k % 7 - 2) * 1e-3};
      const JointResponse   r = closed.respond(at, a), s = ruled.respond(at, b);
      EXPECT_NEAR(r.shear, s.shear, 1e-9 * k_n * 1e-4);
      EXPECT_NEAR(r.shear_by_slip, s.shear_by_slip, 1e-9 * k_s);
      EXPECT_NEAR(r.k_tn, s.k_tn, 1e-9 * k_n);
      EXPECT_EQ(r.state, s.state);
      a = r.history;
      b = s.history;
    }
  EXPECT_GT(a.softening, 0.02);
}



TEST(BondLaw, names_are_different_and_others_are_refused)
{
  for (const BondLaw &law : bond_laws())
    EXPECT_EQ(choose_bonds(law.name, law.name).belt.bond, law.bond);
  try
    {
      choose_bonds("glue");
      FAIL() << "accepted";
    }
  catch (const InputError &error)
    {
      EXPECT_STREQ(error.what(),
                   "there is no law of joints 'glue': it must be bond, belt or rate belt");
    }
}
