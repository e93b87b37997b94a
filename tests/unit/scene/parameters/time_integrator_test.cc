// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/scene_reader.h>
#include <hybrid/scene/parameters/time_integrator.h>

#include <string>
#include <vector>

namespace
{
  using namespace hybrid;
  using namespace hybrid::scene;

  const std::string lamb =
    HYBRID_SOURCE_DIR "/parameters/verification/lamb.prm"; // waves alone, in steps of 0.6 ms


  SceneParameters read(std::vector<std::string> overrides, const std::string &integrator)
  {
    overrides.push_back("Continuum/Time integrator=" + integrator);
    return read_scene(lamb, overrides);
  }


  TEST(TimeIntegrator, ExplicitIsCentralDifferences)
  {
    const SceneParameters scene = read({}, "explicit");
    EXPECT_TRUE(scene.continuum.is_explicit);
    EXPECT_EQ(scene.time.newmark.beta, 0.);
    EXPECT_EQ(scene.time.newmark.gamma, 0.5);
    EXPECT_EQ(scene.time.newmark.corrected_step, 0.);
    EXPECT_FALSE(read({}, "implicit").continuum.is_explicit);
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
          read({override, "Bedding planes/Strength=Mohr-Coulomb"}, "explicit");
          ADD_FAILURE() << override;
        }
      catch (const InputError &error)
        {
          EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        }
  }
} // namespace
