// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/sample_line.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::output;

  /// Ground in two pieces, (0, 0) - (3, 4) - (6, 4) and (8, 4) - (9, 4), edges in no order.
  scene::SectionMesh two_pieces()
  {
    scene::SectionMesh mesh;
    mesh.nodes           = {{0., 0.}, {3., 4.}, {6., 4.}, {8., 4.}, {9., 4.}};
    mesh.lines["ground"] = {{4, 3}, {2, 1}, {0, 1}};
    return mesh;
  }

  scene::SceneParameters scene_of(const std::string &name, const int points)
  {
    scene::SceneParameters scene;
    scene.monitors.lines.push_back({name, {}});
    scene.monitors.line_points = points;
    return scene;
  }
} // namespace



TEST(SampleLine, nodes_of_the_mesh_run_to_the_right_and_gaps_count)
{
  const auto lines = sample_lines(scene_of("ground", 0), two_pieces());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].distance, (std::vector<double>{0., 5., 8., 10., 11.}));
  EXPECT_EQ(lines[0].points[3], Vec2(8., 4.));
  EXPECT_LT((lines[0].tangents[0] - Vec2(0.6, 0.8)).norm(), 1e-15);
  EXPECT_LT((lines[0].tangents[1] - Vec2(1., 0.)).norm(), 1e-15); // of the edge that follows
  EXPECT_FALSE(lines[0].has_sides);
}



TEST(SampleLine, equal_points_skip_gaps)
{
  const auto line = sample_lines(scene_of("ground", 10), two_pieces())[0];
  ASSERT_EQ(line.points.size(), 10u);
  for (int k = 0; k < 9; ++k)
    EXPECT_NEAR(line.distance[k], k, 1e-12);
  EXPECT_NEAR(line.distance[9], 11., 1e-12); // the end beyond the gap
  EXPECT_LT((line.points[5] - Vec2(3., 4.)).norm(), 1e-12);
}



TEST(SampleLine, an_unknown_line_is_told_with_what_there_is)
{
  try
    {
      sample_lines(scene_of("grund", 0), two_pieces());
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("did you mean 'ground'"), std::string::npos)
        << error.what();
    }
}
