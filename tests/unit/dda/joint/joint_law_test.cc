// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_stiffness.h"

#include <hybrid/dda/joint/bedding_strength.h>
#include <hybrid/dda/joint/belt_bond.h>
#include <hybrid/dda/joint/joint_law.h>
#include <hybrid/dda/joint/rock_bond.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;


  Material rock()
  {
    Material m;
    m.name                    = "rock";
    m.friction_angle          = 30.;
    m.cohesion                = 2e4;
    m.tensile_strength        = 1e4;
    m.residual_friction_angle = 20.;
    m.residual_cohesion       = 5e3;
    return m;
  }

  /// G_f = 10 N/m, softening slip 1 mm.
  JointLaw softening()
  {
    return {bond_strength(rock(), 10., 1e-3), k_n, k_s};
  }

  JointLaw brittle()
  {
    return {bond_strength(rock(), 0., 0.), k_n, k_s};
  }

  /// A belt whose residual strength nobody has set.
  Material old_belt()
  {
    Material m                = rock();
    m.residual_friction_angle = Material().residual_friction_angle;
    m.residual_cohesion       = Material().residual_cohesion;
    return m;
  }

  double tan_deg(const double angle)
  {
    return std::tan(angle * M_PI / 180.);
  }
} // namespace



TEST(JointLaw, no_strength_beyond_the_apex_of_the_cone)
{
  const double        apex = 2e4 / tan_deg(30.); // tension [Pa]
  const JointResponse r =
    softening().without_tensile_failure().respond({1.5 * apex / k_n, 1e-4}, {});
  EXPECT_EQ(r.shear, 0.);
  EXPECT_EQ(r.shear_strength, 0.);
  EXPECT_LT(r.mohr_coulomb, -0.4 * 2e4);
}



TEST(JointLaw, compression_is_elastic_and_positive)
{
  const JointResponse r = softening().respond({-1e-6, 0.}, {});
  EXPECT_DOUBLE_EQ(r.normal, k_n * 1e-6);
  EXPECT_DOUBLE_EQ(r.k_nn, k_n);
  EXPECT_EQ(r.state, ContactState::locked);
  EXPECT_EQ(r.history.damage, 0.);
}



TEST(JointLaw, light_shear_sticks_for_both_signs)
{
  for (const double sign : {1., -1.})
    {
      const JointResponse r = softening().respond({-1e-6, sign * 1e-5}, {});
      EXPECT_DOUBLE_EQ(r.shear, -sign * k_s * 1e-5);
      EXPECT_DOUBLE_EQ(r.shear_by_slip, k_s);
      EXPECT_EQ(r.state, ContactState::locked);
    }
}



TEST(JointLaw, shear_above_the_peak_slides_for_both_signs_and_opposes_the_slip)
{
  const JointLaw law(belt_strength(old_belt(), 10., 1e-3), k_n, k_s); // no softening
  for (const double sign : {1., -1.})
    {
      const JointResponse r      = law.respond({-1e-5, sign * 1e-3}, {});
      const double        normal = k_n * 1e-5, strength = 2e4 + normal * tan_deg(30.);
      EXPECT_NEAR(r.shear, -sign * strength, 1e-9 * strength);
      EXPECT_EQ(r.shear_by_slip, 0.);
      EXPECT_EQ(r.state, ContactState::sliding);
      EXPECT_NEAR(r.history.plastic_slip, sign * (1e-3 - strength / k_s), 1e-12);
    }
}



TEST(JointLaw, a_locked_point_bears_what_is_beyond_its_strength)
{
  JointHistory slid;
  slid.plastic_slip = 1e-3;
  for (const double sign : {1., -1.})
    {
      const JointKinematics at{-1e-6, slid.plastic_slip + sign * 1e-3};
      const JointResponse   law  = brittle().respond(at, slid),
                          locked = brittle().respond_locked(at, slid);
      EXPECT_EQ(law.state, ContactState::sliding);
      EXPECT_EQ(locked.state, ContactState::locked);
      EXPECT_DOUBLE_EQ(locked.shear, -sign * k_s * 1e-3);
      EXPECT_GT(std::abs(locked.shear), std::abs(law.shear));
      EXPECT_EQ(locked.shear_by_slip, k_s);
      EXPECT_EQ(locked.k_tn, 0.);
      EXPECT_EQ(locked.normal, law.normal);
      EXPECT_EQ(locked.history.plastic_slip, slid.plastic_slip);
    }
}



TEST(JointLaw, strength_is_continuous_at_the_sliding_limit)
{
  const JointLaw      law   = softening();
  const double        limit = (2e4 + k_n * 1e-6 * tan_deg(30.)) / k_s;
  const JointResponse below = law.respond({-1e-6, limit * (1. - 1e-9)}, {});
  const JointResponse above = law.respond({-1e-6, limit * (1. + 1e-9)}, {});
  EXPECT_EQ(below.state, ContactState::locked);
  EXPECT_EQ(above.state, ContactState::sliding);
  EXPECT_NEAR(below.shear, above.shear, 1e-6 * std::abs(below.shear));
}



TEST(JointLaw, shear_strength_falls_linearly_to_its_residual)
{
  const JointLaw law  = softening();
  const double   peak = 2e4 + 2e4 * tan_deg(30.), residual = 5e3 + 2e4 * tan_deg(20.);
  for (const double kappa : {0.25e-3, 0.5e-3, 0.75e-3, 1e-3, 3e-3})
    {
      const double        part     = std::min(kappa / 1e-3, 1.);
      const double        strength = peak + (residual - peak) * part;
      const JointResponse r        = law.respond({-1e-5, kappa + strength / k_s}, {});
      EXPECT_NEAR(r.shear, -strength, 1e-9 * peak);
      EXPECT_NEAR(r.history.softening, kappa, 1e-12);
      EXPECT_EQ(law.broken_in_shear(r.history), kappa >= 1e-3) << kappa;
    }
}



TEST(JointLaw, softening_over_many_steps_equals_one_step)
{
  const JointLaw      law  = softening();
  const JointResponse once = law.respond({-1e-5, 7e-4}, {});
  JointHistory        history;
  JointResponse       r;
  for (int i = 1; i <= 700; ++i)
    {
      r       = law.respond({-1e-5, i * 1e-6}, history);
      history = r.history;
    }
  EXPECT_NEAR(r.shear, once.shear, 1e-9 * std::abs(once.shear));
  EXPECT_NEAR(history.softening, once.history.softening, 1e-12);
}



TEST(JointLaw, brittle_bond_drops_to_the_residual_at_once)
{
  const JointLaw      law   = brittle();
  const double        limit = (2e4 + 2e4 * tan_deg(30.)) / k_s;
  const JointResponse shear = law.respond({-1e-5, limit * 1.0001}, {});
  EXPECT_EQ(shear.state, ContactState::sliding);
  EXPECT_TRUE(law.broken_in_shear(shear.history));
  EXPECT_NEAR(shear.shear, -(5e3 + 2e4 * tan_deg(20.)), 1e-6);

  const double        elastic = 1e4 / k_n;
  const JointResponse intact  = law.respond({elastic * 0.9999, 0.}, {});
  const JointResponse open    = law.respond({elastic * 1.0001, 0.}, {});
  EXPECT_NEAR(intact.normal, -0.9999e4, 1e-6);
  EXPECT_EQ(open.state, ContactState::open);
  EXPECT_EQ(open.normal, 0.);
  EXPECT_EQ(open.shear, 0.);
  EXPECT_TRUE(law.broken_in_tension(open.history));
}



TEST(JointLaw, opening_follows_linear_softening_and_its_area_is_the_fracture_energy)
{
  const JointLaw law      = softening();
  const double   critical = 2. * 10. / 1e4, elastic = 1e4 / k_n; // m
  JointHistory   history;
  double         area = 0., before = 0., damage = 0.;
  const int      n = 200000;
  for (int i = 1; i <= n; ++i)
    {
      const double        gap      = 1.01 * critical * i / n;
      const JointResponse r        = law.respond({gap, 0.}, history);
      const double        expected = gap <= elastic    ? k_n * gap
                                     : gap >= critical ? 0.
                                                       : 1e4 * (critical - gap) / (critical - elastic);
      ASSERT_NEAR(-r.normal, expected, 1e-6 * 1e4);
      ASSERT_GE(r.history.damage, damage);
      area += 0.5 * (before - r.normal) * 1.01 * critical / n;
      before  = -r.normal;
      damage  = r.history.damage;
      history = r.history;
    }
  EXPECT_NEAR(area, 10., 1e-4 * 10.);
  EXPECT_NEAR(law.fracture_loss(history), 10., 1e-9 * 10.);
  EXPECT_TRUE(law.broken_in_tension(history));
}



TEST(JointLaw, unloading_goes_to_the_origin_and_damage_never_heals)
{
  const JointLaw      law   = softening();
  const JointResponse there = law.respond({1e-3, 0.}, {});
  const JointResponse back  = law.respond({5e-4, 0.}, there.history);
  EXPECT_NEAR(back.normal, 0.5 * there.normal, 1e-9 * 1e4);
  EXPECT_EQ(back.history.damage, there.history.damage);
  const JointResponse pressed = law.respond({-1e-6, 0.}, there.history);
  EXPECT_DOUBLE_EQ(pressed.normal, k_n * 1e-6);
  EXPECT_EQ(pressed.history.damage, there.history.damage);
}



TEST(JointLaw, fracture_loss_is_the_area_between_loading_and_unloading)
{
  const JointLaw law = softening();
  for (const double gap : {2e-5, 2e-4, 1e-3, 1.9e-3})
    {
      JointHistory history;
      double       area = 0., before = 0.;
      const int    n = 400000;
      for (int i = 1; i <= n; ++i)
        {
          const JointResponse r = law.respond({gap * i / n, 0.}, history);
          history               = r.history;
          area += 0.5 * (before - r.normal) * gap / n;
          before = -r.normal;
        }
      const double stored = law.stored_energy({gap, 0.}, history);
      EXPECT_NEAR(law.fracture_loss(history), area - stored, 1e-4 * area) << gap;
    }
}


TEST(JointLaw, damped_bond_breaks_at_its_strength_at_any_rate)
{
  const JointLaw law      = softening();
  const double   critical = 2. * 10. / 1e4, elastic = 1e4 / k_n; // m
  for (const double ratio : {0., 0.1, 1., 10., 100.})
    for (const double step : {0.02 * elastic, 0.5 * elastic, 7. * elastic})
      {
        JointHistory history;
        double       gap = 0., peak = 0., work = 0., viscous = 0.;
        double       elastic_before = 0.;
        while (gap < critical)
          {
            const JointResponse r = law.respond({gap + step, 0.}, history, {ratio, gap, 0.});
            const JointResponse e = law.respond({gap + step, 0.}, history);
            EXPECT_EQ(r.elastic_normal, e.normal);
            EXPECT_EQ(r.history.damage, e.history.damage);
            EXPECT_LE(r.normal, e.normal); // the dashpot resists
            viscous += (e.normal - r.normal) * step;
            work -= 0.5 * (elastic_before + e.normal) * step;
            elastic_before = e.normal;
            peak           = std::max(peak, -r.normal);
            history        = r.history;
            gap += step;
          }
        EXPECT_LE(peak, 1e4 * (1. + 1e-12)) << ratio << ' ' << step;
        if (step < elastic)
          {
            EXPECT_NEAR(peak, 1e4, 0.01 * 1e4) << ratio << ' ' << step;
            EXPECT_NEAR(work, 10., 0.01 * 10.);
          }
        EXPECT_NEAR(law.fracture_loss(history), 10., 1e-8);
        EXPECT_TRUE(law.broken_in_tension(history));
        EXPECT_GE(viscous, 0.);
        EXPECT_LE(viscous, 1e4 * elastic); // less than the area between F_t and the spring
      }
}



TEST(JointLaw, tangent_of_a_damped_bond_is_the_derivative_of_its_traction)
{
  const JointLaw law      = softening();
  const double   elastic  = 1e4 / k_n;
  JointHistory   damaged  = law.respond({2e-4, 0.}, {}).history; // bears less than F_t
  const double   left     = -law.respond({2e-4, 0.}, damaged).normal;
  const auto     traction = [&](const double gap, const JointHistory &h, const double start) {
    return law.respond({gap, 0.}, h, {3., start, 0.});
  };
  struct Case
  {
    double       gap, start;
    JointHistory history;
    double       expected; // Pa, compression positive
  };
  const Case cases[] = {
    {-2e-6, -1e-6, {}, k_n * 5e-6},                      // closes
    {-1e-6, -1.1e-6, {}, k_n * (1e-6 - 3e-7)},           // unloads
    {-1e-6, -1e-5, {}, -1e4},                            // unloads fast
    {0.2 * elastic, 0.1 * elastic, {}, -0.5e4},          // opens
    {0.5 * elastic, 0.2 * elastic, {}, -1e4},            // faster than the bond bears
    {0.5 * elastic, 0.6 * elastic, {}, -0.2e4},          // closes in tension
    {2. * elastic, 0.5 * elastic, {}, 0.},               // cracks
    {1e-4, 0.99e-4, damaged, -0.5 * left * (1. + 0.03)}, // opens again
    {1e-4, 0., damaged, -left},                          // likewise, fast
    {3e-4, 1e-4, damaged, 0.},                           // cracks on
    {1e-4, 1.01e-4, damaged, -0.5 * left * (1. - 0.03)}, // closes again
  };
  for (const Case &c : cases)
    {
      const double        h     = 1e-6 * elastic;
      const JointResponse r     = traction(c.gap, c.history, c.start);
      const double        slope = (traction(c.gap - h, c.history, c.start).normal -
                            traction(c.gap + h, c.history, c.start).normal) /
                           (2. * h);
      EXPECT_NEAR(r.k_nn, slope, 1e-4 * k_n) << c.gap << ' ' << c.start;
      const double expected =
        c.expected == 0. ? law.respond({c.gap, 0.}, c.history).normal : c.expected;
      EXPECT_NEAR(r.normal, expected, 1e-9 * 1e4) << c.gap << ' ' << c.start;
    }
}



TEST(JointLaw, tensile_damage_takes_its_part_of_the_cohesion)
{
  const JointLaw law = softening();
  JointHistory   half;
  half.damage            = 0.5;
  const JointResponse r  = law.respond({0., 0.01}, half);
  JointHistory        at = r.history;
  EXPECT_NEAR(-r.shear, 5e3, 1e-6); // far beyond the softening slip
  at               = half;
  const double cap = 5e3 + 0.5 * 1.5e4;
  EXPECT_EQ(law.respond({0., 0.999 * cap / k_s}, at).state, ContactState::locked);
  EXPECT_EQ(law.respond({0., 1.001 * cap / k_s}, at).state, ContactState::sliding);
}



TEST(JointLaw, broken_contact_carries_neither_tension_nor_cohesion_above_residual)
{
  const JointLaw law(contact_strength(rock()), k_n, k_s);
  EXPECT_EQ(law.respond({1e-5, 1e-3}, {}).state, ContactState::open);
  const JointResponse r = law.respond({-1e-5, 1e-2}, {});
  EXPECT_NEAR(-r.shear, 5e3 + 2e4 * tan_deg(20.), 1e-6);
}



TEST(JointLaw, residual_cohesion_fades_while_a_broken_contact_opens)
{
  const JointLaw law(contact_strength(rock()), k_n, k_s);
  const double   reach = 5e3 / k_n, h = 1e-4 * reach;
  EXPECT_NEAR(-law.respond({-1e-9 * reach, 1e-2}, {}).shear, 5e3, 1e-3);
  EXPECT_NEAR(-law.respond({1e-9 * reach, 1e-2}, {}).shear, 5e3, 1e-3);
  const JointResponse half = law.respond({0.5 * reach, 1e-2}, {});
  EXPECT_NEAR(-half.shear, 2.5e3, 1e-6);
  EXPECT_EQ(half.normal, 0.);
  const double ahead = law.respond({0.5 * reach + h, 1e-2}, {}).shear;
  EXPECT_NEAR(half.k_tn, -(ahead - half.shear) / h, 1e-6 * k_n);
  EXPECT_EQ(law.respond({reach, 1e-2}, {}).shear, 0.);
}



TEST(JointLaw, open_joint_starts_its_friction_spring_anew)
{
  const JointLaw      law(contact_strength(rock()), k_n, k_s);
  const JointResponse open   = law.respond({1e-3, 0.4}, {});
  const JointResponse closed = law.respond({-1e-6, 0.4 + 1e-7}, open.history);
  EXPECT_EQ(closed.state, ContactState::locked);
  EXPECT_NEAR(closed.shear, -k_s * 1e-7, 1e-4);
}



TEST(JointLaw, residual_cohesion_acts_on_the_length_of_the_edges)
{
  const JointLaw law(contact_strength(rock()), k_n, k_s);
  EXPECT_TRUE(law.has_residual_cohesion());
  EXPECT_FALSE(law.with(JointStrength::unlimited_friction()).has_residual_cohesion());
  const double friction = 2e4 * tan_deg(20.);
  for (const double part : {0., 0.5, 1., 3.})
    {
      EXPECT_NEAR(-law.respond({-1e-5, 1e-2, part}, {}).shear, part * 5e3 + friction, 1e-6);
      // it fades as fast as the springs unload
      const double        reach = part * 5e3 / k_n;
      const JointResponse half  = law.respond({0.5 * reach, 1e-2, part}, {});
      EXPECT_NEAR(-half.shear, 0.5 * part * 5e3, 1e-6);
      EXPECT_NEAR(half.k_tn, part > 0. ? -k_n : 0., 1e-6 * k_n);
      EXPECT_EQ(law.respond({1.0001 * reach + 1e-12, 1e-2, part}, {}).shear, 0.);
    }
}



TEST(JointLaw, unlimited_strengths_neither_break_nor_slip)
{
  const JointLaw bond     = softening().with(JointStrength::unlimited_bond());
  const JointLaw friction = softening().with(JointStrength::unlimited_friction());
  EXPECT_DOUBLE_EQ(bond.respond({1., 0.}, {}).normal, -k_n);
  EXPECT_DOUBLE_EQ(bond.respond({0., 1.}, {}).shear, -k_s);
  EXPECT_DOUBLE_EQ(friction.respond({-1e-6, 1.}, {}).shear, -k_s);
  EXPECT_EQ(friction.respond({1e-6, 1.}, {}).state, ContactState::open);
}



TEST(JointLaw, cyclic_shear_dissipates_the_area_of_the_loop)
{
  const JointLaw law(contact_strength(rock()), k_n, k_s);
  const double   strength = 5e3 + 2e4 * tan_deg(20.), amplitude = 1e-3;
  JointHistory   history;
  double         work = 0., slip = 0., force = 0.;
  const int      n     = 4000;
  double         first = 0.;
  for (int i = 1; i <= 5 * n; ++i) // quarter, then one full cycle from the positive peak
    {
      const double        next = amplitude * std::sin(0.5 * M_PI * i / n);
      const JointResponse r    = law.respond({-1e-5, next}, history);
      work += -0.5 * (force + r.shear) * (next - slip);
      slip    = next;
      force   = r.shear;
      history = r.history;
      if (i == n)
        first = work;
    }
  EXPECT_NEAR(work - first, 4. * strength * (amplitude - strength / k_s), 1e-3 * work);
}



TEST(JointLaw, a_bedding_plane_keeps_its_strength_while_it_slips)
{
  scene::BeddingParameters bedding;
  bedding.slips            = true;
  bedding.friction_angle   = 30.;
  bedding.cohesion         = 2e4;
  bedding.tensile_strength = 1e4;
  const JointLaw law(bedding_strength(bedding), k_n, k_s);
  const double   strength = 2e4 + k_n * 1e-5 * tan_deg(30.);
  JointHistory   history;
  for (const double slip : {1e-3, 1., 100., -100.})
    {
      const JointResponse r = law.respond({-1e-5, slip}, history);
      EXPECT_NEAR(r.shear, -std::copysign(strength, slip), 1e-9 * strength);
      EXPECT_EQ(r.shear_by_slip, 0.);
      EXPECT_NEAR(std::abs(r.k_tn), k_n * tan_deg(30.), 1e-6);
      EXPECT_EQ(r.state, ContactState::sliding);
      EXPECT_FALSE(law.broken_in_shear(r.history));
      history = r.history;
    }
}



TEST(JointLaw, a_bedding_plane_that_opened_beyond_the_cut_off_has_friction_only)
{
  scene::BeddingParameters bedding;
  bedding.slips            = true;
  bedding.friction_angle   = 30.;
  bedding.cohesion         = 2e4;
  bedding.tensile_strength = 1e6; // c / tan phi counts
  const double   cut_off   = 2e4 / tan_deg(30.);
  const JointLaw law(bedding_strength(bedding), k_n, k_s);
  const auto     closed = law.respond({0.999 * cut_off / k_n, 0.}, {});
  EXPECT_NEAR(closed.normal, -0.999 * cut_off, 1e-9 * cut_off);
  EXPECT_EQ(closed.history.damage, 0.);
  const auto open = law.respond({1.001 * cut_off / k_n, 1e-3}, {});
  EXPECT_EQ(open.normal, 0.);
  EXPECT_EQ(open.shear, 0.);
  EXPECT_EQ(open.state, ContactState::open);
  EXPECT_TRUE(law.broken_in_tension(open.history));
  const auto again = law.respond({-1e-5, 2e-3}, open.history);
  EXPECT_NEAR(again.shear, -k_n * 1e-5 * tan_deg(30.), 1e-6);
}
