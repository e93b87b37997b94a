// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/springs/torn_bond.h>

#include <gtest/gtest.h>

namespace hybrid::dda::test
{
  namespace
  {
    constexpr double k_n = 2e9, k_s = 1e9, gamma = 0.6;

    JointStrength brittle()
    {
      JointStrength strength;
      strength.tensile  = 1e5;
      strength.cohesion = 1e6;
      strength.tan_phi  = 0.5;
      return strength;
    }



    const JointLaw law(brittle(), k_n, k_s);



    /// An intact bond with this gap and slip.
    Springs::Spring bond(const double gap, const double slip)
    {
      Springs::Spring spring;
      spring.law        = &law;
      spring.old.gap    = gap;
      spring.old.slip   = slip;
      spring.old.normal = spring.old.elastic_normal = -k_n * gap;
      spring.old.shear = spring.old.elastic_shear = -k_s * slip;
      return spring;
    }



    /// At the end of a trial, torn or not.
    SpringState at(const double gap, const double slip, const double damage = 1.)
    {
      SpringState now;
      now.gap            = gap;
      now.slip           = slip;
      now.history.damage = damage;
      return now;
    }
  } // namespace



  TEST(TornBond, GivesWhatItHasStored)
  {
    const double          g = -1e-4, s = 2e-4, opening = 3e-3, slip = -1e-3;
    const Springs::Spring spring = bond(g, s);
    const auto            taken  = taken_back(spring, at(opening, slip), gamma).traction;
    EXPECT_NEAR(((1. - gamma) * -k_n * g - gamma * taken.normal) * (opening - g),
                0.5 * k_n * g * g,
                1e-9 * k_n * g * g);
    EXPECT_NEAR(((1. - gamma) * -k_s * s - gamma * taken.shear) * (slip - s),
                0.5 * k_s * s * s,
                1e-9 * k_s * s * s);
  }



  TEST(TornBond, TakesNothingBackWhileItGivesLess)
  {
    const Springs::Spring spring = bond(-1e-4, 0.);
    const double          least  = 0.5 * 1e-4 / (1. - gamma); // of the way
    EXPECT_EQ(taken_back(spring, at(least * 0.999 - 1e-4, 0.), gamma).traction.normal, 0.);
    EXPECT_NEAR(taken_back(spring, at(least * 1.001 - 1e-4, 0.), gamma).traction.normal,
                0.,
                1e-3 * k_n * 1e-4);
    EXPECT_EQ(taken_back(bond(1e-5, 0.), at(1e-2, 0.), gamma).traction.normal, 0.) << "tension";
    EXPECT_EQ(taken_back(spring, at(1e-2, 0.), 1.).traction.normal, 0.) << "gamma = 1 carries none";
    EXPECT_EQ(taken_back(spring, at(1e-2, 0., 0.), gamma).traction.normal, 0.) << "not torn";
  }



  TEST(TornBond, CountsThePartThatTearsInThisStep)
  {
    Springs::Spring spring    = bond(-1e-4, 0.);
    const double    whole     = taken_back(spring, at(1e-2, 0.), gamma).traction.normal;
    const double    half      = taken_back(spring, at(1e-2, 0., 0.5), gamma).traction.normal;
    spring.contact_fraction   = 0.5;
    const double other_half   = taken_back(spring, at(1e-2, 0.), gamma).traction.normal;
    const double nothing_more = taken_back(spring, at(1e-2, 0., 0.5), gamma).traction.normal;
    EXPECT_NEAR(half, 0.5 * whole, 1e-12 * whole);
    EXPECT_NEAR(other_half, 0.5 * whole, 1e-12 * whole);
    EXPECT_EQ(nothing_more, 0.);
  }



  TEST(TornBond, DerivativesAreThoseOfTheTraction)
  {
    const Springs::Spring spring = bond(-1e-4, 2e-4);
    const double          h      = 1e-9;
    const auto            taken  = [&](const double gap, const double slip) {
      return taken_back(spring, at(gap, slip), gamma);
    };
    const TakenBack here = taken(1e-3, -1e-3);
    EXPECT_NEAR((taken(1e-3 + h, -1e-3).traction.normal - taken(1e-3 - h, -1e-3).traction.normal) /
                  (2. * h),
                here.by_gap,
                1e-5 * here.by_gap);
    EXPECT_NEAR((taken(1e-3, -1e-3 + h).traction.shear - taken(1e-3, -1e-3 - h).traction.shear) /
                  (2. * h),
                here.by_slip,
                1e-5 * here.by_slip);
    EXPECT_GT(here.by_gap, 0.);
    EXPECT_GT(here.by_slip, 0.);
  }
} // namespace hybrid::dda::test
