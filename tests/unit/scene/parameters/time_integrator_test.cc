// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/time_integrator.h>

#include "lamb_scene.h"

#include <string>

namespace
{
  using namespace hybrid;
  using namespace hybrid::scene;

  TEST(TimeIntegrator, ExplicitIsCentralDifferences)
  {
    const SceneParameters scene = test::lamb_scene({}, "explicit");
    EXPECT_TRUE(scene.continuum.is_explicit);
    EXPECT_EQ(scene.time.newmark.beta, 0.);
    EXPECT_EQ(scene.time.newmark.gamma, 0.5);
    EXPECT_EQ(scene.time.newmark.corrected_step, 0.);
    EXPECT_FALSE(test::lamb_scene({}, "implicit").continuum.is_explicit);
  }


  TEST(TimeIntegrator, ExplicitIsRefusedWithTheReason)
  {
    const std::pair<std::string, std::string> wrong[] = {
      {"Model/Bedrock=rigid", "not of finite elements"},
      {"Time/Scheme=trapezoidal", "Time/Scheme"},
      {"Bedding planes/Names=bedding_1", "may slip"}};
    for (const auto &[override, reason] : wrong)
      try
        {
          test::lamb_scene({override, "Bedding planes/Strength=Mohr-Coulomb"}, "explicit");
          ADD_FAILURE() << override;
        }
      catch (const InputError &error)
        {
          EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        }
  }
} // namespace
