// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/scene/mesh/stable_step.h>
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


  /// One cell of the lamb scene, h = 25 m, or another size.
  SectionMesh cell_of(const double h)
  {
    SectionMesh mesh;
    mesh.nodes                = {Vec2(0., 0.), Vec2(h, 0.), Vec2(h, h), Vec2(0., h)};
    mesh.bedrock_cells        = {{0, 1, 2, 3}};
    mesh.bedrock_region       = {0};
    mesh.bedrock_region_names = {"bedrock"};
    return mesh;
  }


  TEST(StableStep, AutomaticIsExplicitWhereAStepHasFewStableParts)
  {
    const auto is_explicit = [](const std::string &step, const double h) {
      return with_time_integrator(read({"Time/Time step=" + step}, "automatic"), cell_of(h))
        .continuum.is_explicit;
    };
    EXPECT_TRUE(is_explicit("0.0006", 25.));
    EXPECT_TRUE(is_explicit("0.006", 25.));
    EXPECT_FALSE(is_explicit("0.06", 25.));
    EXPECT_FALSE(is_explicit("0.006", 1.));
  }


  TEST(StableStep, AutomaticIsImplicitWhereExplicitCannotBe)
  {
    const SceneParameters scene = read({"Time/Scheme=trapezoidal"}, "automatic");
    EXPECT_NE(why_not_explicit(scene), "");
    EXPECT_FALSE(with_time_integrator(scene, cell_of(25.)).continuum.is_explicit);
  }


  TEST(StableStep, IsThatOfTheNearestNodes)
  {
    const SceneParameters scene = read({}, "explicit");
    const double          h     = estimated_stable_step(cell_of(25.), scene);
    EXPECT_NEAR(estimated_stable_step(cell_of(50.), scene), 2. * h, 1e-12);
    // c_p 3000 m/s, degree 4: nodes 0.173 of a cell apart; the run of this scene takes 0.66 ms
    EXPECT_GT(h, 0.0006);
    EXPECT_LT(h, 0.0010);
  }
} // namespace
