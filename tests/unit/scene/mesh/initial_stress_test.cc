// SPDX-License-Identifier: GPL-3.0-or-later
#include "../scene_files.h"

#include <hybrid/scene/mesh/initial_stress.h>

#include <cmath>

using namespace hybrid;
using namespace hybrid::scene;

using InitialStressOption = test::SceneFiles;

namespace
{
  /// The lines of an option, with a friction angle of clay.
  std::string option(const std::string &value, const std::string &more = "")
  {
    return "subsection Gravity\n  set Initial stress = " + value + "\n" + more + "end\n" +
           "subsection Materials\n  subsection clay\n    set Friction angle = 30\n  end\nend\n";
  }

  double ratio(const SceneParameters &scene, const std::string &material)
  {
    return scene.materials.at(material).lateral_ratio();
  }
} // namespace



TEST_F(InitialStressOption, is_elastic_a_number_or_by_friction)
{
  SceneParameters scene = read_scene(write_scene());
  EXPECT_FALSE(scene.environment.has_initial_stress());
  EXPECT_NEAR(ratio(scene, "clay"), 1. / 3., 1e-15);
  scene = read_scene(write_scene(option("0.7")));
  EXPECT_TRUE(scene.environment.has_initial_stress());
  EXPECT_EQ(ratio(scene, "rock"), 0.7);
  EXPECT_EQ(ratio(scene, "clay"), 0.7);
  scene = read_scene(write_scene(option("1 - sin phi")));
  EXPECT_NEAR(ratio(scene, "clay"), 0.5, 1e-15);
  EXPECT_NEAR(ratio(scene, "rock"), 1. / 3., 1e-15); // has no friction angle of its own
}



TEST_F(InitialStressOption, may_differ_by_material)
{
  const SceneParameters scene = read_scene(write_scene(option("clay: 1 - sin phi; rock: 1.2")));
  EXPECT_NEAR(ratio(scene, "clay"), 0.5, 1e-15);
  EXPECT_EQ(ratio(scene, "rock"), 1.2);
  EXPECT_NEAR(ratio(read_scene(write_scene(option("rock: 1.2"))), "clay"), 1. / 3., 1e-15);
}



TEST_F(InitialStressOption, is_that_of_strengths_before_they_are_reduced)
{
  const SceneParameters scene =
    read_scene(write_scene(option("1 - sin phi")), {"Materials/Strength reduction factor=2"});
  EXPECT_LT(scene.materials.at("clay").friction_angle, 20.);
  EXPECT_NEAR(ratio(scene, "clay"), 0.5, 1e-15);
}



TEST_F(InitialStressOption, staged_needs_joints_and_weight)
{
  const std::string staged = "Gravity/Initial stress=staged", belt = "Blocks/Belt material=clay";
  const SceneParameters scene = read_scene(write_scene(), {staged, belt, "Gravity/Lifts=7"});
  EXPECT_TRUE(scene.environment.is_staged());
  EXPECT_FALSE(scene.environment.has_initial_stress()); // of its overburden: the bedrock is elastic
  EXPECT_EQ(scene.environment.lifts, 7);
  EXPECT_FALSE(read_scene(write_scene(), {"Gravity/Lifts=7"}).environment.is_staged());
  const auto refused = [&](const std::vector<std::string> &overrides, const std::string &part) {
    try
      {
        read_scene(write_scene(), overrides);
      }
    catch (const InputError &error)
      {
        return std::string(error.what()).find(part) != std::string::npos;
      }
    return false;
  };
  const std::string place = "Gravity/Initial stress = 'staged': needs ";
  EXPECT_TRUE(refused({staged}, place + "Blocks/Belt material"));
  EXPECT_TRUE(refused({staged, belt, "Model/Blocks=loose"}, place + "a bonded mass"));
  EXPECT_TRUE(refused({staged, belt, "Model/Blocks=none"}, place + "a bonded mass"));
  EXPECT_TRUE(refused({staged, belt, "Gravity/Acceleration=0"}, place + "gravity"));
  EXPECT_TRUE(refused({staged, belt, "Gravity/Static stage=none"}, place + "a static stage"));
  for (const char *lifts : {"0", "1001", "2.5", "-1", "many"})
    EXPECT_TRUE(
      refused({staged, belt, std::string("Gravity/Lifts=") + lifts}, "an integer from 1 to 1000"))
      << lifts;
}



TEST_F(InitialStressOption, nonsense_is_refused)
{
  const auto message = [&](const std::string &value, const std::string &more = "") {
    try
      {
        read_scene(write_scene(option(value, more)));
      }
    catch (const InputError &error)
      {
        return std::string(error.what());
      }
    return std::string();
  };
  for (const char *value : {"rock: staged", "-0.1", "11", "sin phi", "rock: 0.5 0.7", "rock; clay"})
    EXPECT_NE(message(value).find("Gravity/Initial stress"), std::string::npos) << value;
  EXPECT_NE(message("clya: 0.5").find("did you mean 'clay'?"), std::string::npos);
  EXPECT_NE(message("0.5", "  set Static stage = none\n").find("needs a static stage"),
            std::string::npos);
}
