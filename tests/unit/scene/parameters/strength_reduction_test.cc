// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/strength_reduction.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    double tan_degrees(const double angle)
    {
      return std::tan(angle * M_PI / 180.);
    }



    TEST(StrengthReduction, DividesCohesionTensionAndTheTangentOfFrictionEverywhere)
    {
      SceneParameters scene;
      Material       &soil         = scene.materials["soil"];
      soil.friction_angle          = 40.;
      soil.residual_friction_angle = 20.;
      soil.cohesion                = 9.;
      soil.tensile_strength        = 6.;
      soil.dilation_angle          = 35.;
      soil.residual_cohesion       = 3.;
      soil.young_modulus           = 5e6;
      scene.bedding.friction_angle = 25.;
      scene.bedding.cohesion       = 4.;
      scene.materials["rock"]      = {}; // nothing given: residual as peak
      const Material untouched     = scene.materials["rock"];
      divide_strengths(scene, 1.5);
      EXPECT_NEAR(tan_degrees(soil.friction_angle), tan_degrees(40.) / 1.5, 1e-14);
      EXPECT_NEAR(tan_degrees(soil.residual_friction_angle), tan_degrees(20.) / 1.5, 1e-14);
      EXPECT_EQ(soil.dilation_angle, soil.friction_angle); // no more than friction
      EXPECT_DOUBLE_EQ(soil.cohesion, 6.);
      EXPECT_DOUBLE_EQ(soil.tensile_strength, 4.);
      EXPECT_DOUBLE_EQ(soil.residual_cohesion, 2.);
      EXPECT_EQ(soil.young_modulus, 5e6);
      EXPECT_NEAR(tan_degrees(scene.bedding.friction_angle), tan_degrees(25.) / 1.5, 1e-14);
      EXPECT_NEAR(scene.bedding.cohesion, 4. / 1.5, 1e-14);
      const Material &rock = scene.materials["rock"];
      EXPECT_NEAR(tan_degrees(rock.friction_angle), tan_degrees(30.) / 1.5, 1e-14);
      EXPECT_EQ(rock.given_friction_angle, untouched.given_friction_angle);
      EXPECT_EQ(rock.residual_friction_angle, untouched.residual_friction_angle);
      EXPECT_EQ(rock.residual_cohesion, untouched.residual_cohesion);
    }
  } // namespace
} // namespace hybrid::scene
