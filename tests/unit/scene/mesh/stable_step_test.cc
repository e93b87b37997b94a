// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/scene/mesh/stable_step.h>
#include <hybrid/scene/parameters/time_integrator.h>

#include "lamb_scene.h"

#include <string>

namespace
{
  using namespace hybrid;
  using namespace hybrid::scene;

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
      return with_time_integrator(test::lamb_scene({"Time/Time step=" + step}, "automatic"),
                                  cell_of(h))
        .continuum.is_explicit;
    };
    EXPECT_TRUE(is_explicit("0.0006", 25.));
    EXPECT_TRUE(is_explicit("0.006", 25.));
    EXPECT_FALSE(is_explicit("0.06", 25.));
    EXPECT_FALSE(is_explicit("0.006", 1.));
  }


  TEST(StableStep, AutomaticIsImplicitWhereExplicitCannotBe)
  {
    const SceneParameters scene = test::lamb_scene({"Time/Scheme=trapezoidal"}, "automatic");
    EXPECT_NE(why_not_explicit(scene), "");
    EXPECT_FALSE(with_time_integrator(scene, cell_of(25.)).continuum.is_explicit);
  }


  TEST(StableStep, IsThatOfTheNearestNodes)
  {
    const SceneParameters scene = test::lamb_scene({}, "explicit");
    const double          h     = estimated_stable_step(cell_of(25.), scene);
    EXPECT_NEAR(estimated_stable_step(cell_of(50.), scene), 2. * h, 1e-12);
    // c_p 3000 m/s, degree 4: nodes 0.173 of a cell apart; Lanczos finds 0.93 ms
    EXPECT_GT(h, 0.0008);
    EXPECT_LT(h, 0.0010);
  }
} // namespace
