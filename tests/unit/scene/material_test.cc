// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/material.h>

#include <gtest/gtest.h>

#include <cmath>

using hybrid::Material;

TEST(Material, WaveSpeedsOfBedrockMatchClosedForm)
{
  Material rock;
  rock.density       = 2450.;
  rock.young_modulus = 60e9;
  rock.poisson_ratio = 0.2;
  // c_s^2 = E / (2 (1 + nu) rho), c_p^2 = E (1 - nu) / ((1 + nu) (1 - 2 nu) rho)
  EXPECT_NEAR(rock.s_wave_speed(), std::sqrt(60e9 / (2.4 * 2450.)), 1e-9);
  EXPECT_NEAR(rock.p_wave_speed(), std::sqrt(60e9 * 0.8 / (1.2 * 0.6 * 2450.)), 1e-9);
  EXPECT_NEAR(rock.s_wave_speed(), 3194., 1.); // the figure of the literature for this rock
}

TEST(Material, WaveSpeedsOfCauchySolidDifferBySqrtThree)
{
  Material solid;
  solid.poisson_ratio = 0.25; // lambda = G
  EXPECT_NEAR(solid.p_wave_speed() / solid.s_wave_speed(), std::sqrt(3.), 1e-14);
}

TEST(Material, WeightDensityIsDensityUnlessGiven)
{
  Material soil;
  soil.density = 2320.;
  EXPECT_EQ(soil.weighing_density(), 2320.);
  soil.weight_density = 1320.;
  EXPECT_EQ(soil.weighing_density(), 1320.);
}
