// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/output/probes.h>
#include <hybrid/output/watched_points.h>

#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string>

namespace
{
  using namespace hybrid;
  using namespace hybrid::output;

  /// Rows of squares of 2 m on a level base.
  dda::Model squares(const int columns, const int rows)
  {
    return dda::build_model(hybrid::test::square_blocks(columns, rows, 2.),
                            hybrid::test::block_parameters(30.),
                            hybrid::test::straight_foundation(0., 1., 3. * columns));
  }



  /// Bedrock of square cells of 10 m, 100 m wide and 30 m high, its ground at y = 0.
  scene::SectionMesh level_ground()
  {
    scene::SectionMesh mesh;
    for (int row = 0; row <= 3; ++row)
      for (int k = 0; k <= 10; ++k)
        mesh.nodes.emplace_back(10. * k, 10. * row - 30.);
    for (int row = 0; row < 3; ++row)
      for (int k = 0; k < 10; ++k)
        {
          const int n = 11 * row + k;
          mesh.bedrock_cells.push_back({{n, n + 1, n + 12, n + 11}});
        }
    for (int k = 0; k < 10; ++k)
      {
        mesh.lines["base"].push_back({{k, k + 1}});
        mesh.lines["ground"].push_back({{34 + k, 33 + k}});
      }
    return mesh;
  }
} // namespace



TEST(WatchedPoints, are_centroids_of_blocks_and_a_point_of_the_rigid_base)
{
  const dda::Model    model   = squares(20, 1);
  const WatchedPoints watched = watched_points({}, &model, false);
  ASSERT_EQ(watched.points.size(), 9u);
  EXPECT_EQ(watched.text(), "8 blocks");
  EXPECT_EQ(watched.points.back().name, "base");
  double left = 1e9, right = -1e9;
  Probes probes(&model, nullptr);
  for (const scene::Monitor &point : watched.points)
    {
      const int number = probes.add(point.position, point.name);
      EXPECT_EQ(probes.block(number) >= 0, point.name != "base") << point.name;
      left  = std::min(left, point.name == "base" ? left : point.position.x());
      right = std::max(right, point.name == "base" ? right : point.position.x());
    }
  EXPECT_NEAR(right - left, 38., 1e-9) << "both ends of the row";
}



TEST(WatchedPoints, of_few_blocks_are_all_of_them)
{
  const dda::Model    model   = squares(1, 1);
  const WatchedPoints watched = watched_points({}, &model, false);
  ASSERT_EQ(watched.points.size(), 2u);
  EXPECT_EQ(watched.text(), "1 block");
}



TEST(WatchedPoints, of_waves_alone_lie_at_the_ground_relative_to_the_base)
{
  const WatchedPoints watched = watched_points(level_ground(), nullptr, true);
  ASSERT_EQ(watched.points.size(), 9u);
  EXPECT_EQ(watched.text(), "8 points of the bedrock");
  for (int k = 0; k < 8; ++k)
    EXPECT_EQ(watched.points[k].position.y(), -5.);
  EXPECT_EQ(watched.points[1].position.x(), 95.) << "as far as can be from the middle, 45";
  EXPECT_EQ(watched.points.back().position, Vec2(50., -30.));
}



TEST(WatchedPoints, of_both_are_blocks_first_and_then_bedrock)
{
  const dda::Model    model   = squares(3, 2);
  const WatchedPoints watched = watched_points(level_ground(), &model, true);
  EXPECT_EQ(watched.text(), "6 blocks and 4 points of the bedrock");
  ASSERT_EQ(watched.points.size(), 11u);
  EXPECT_GT(watched.points[5].position.y(), 0.);
  EXPECT_LT(watched.points[6].position.y(), 0.);
}



// As names of monitors: letters, digits, '_', '-' and '.', each once.
TEST(WatchedPoints, have_names_of_coordinates_of_any_size)
{
  scene::SectionMesh mesh = level_ground();
  for (Vec2 &node : mesh.nodes)
    node = Vec2(5e5, 4e6) + 1e-3 * node;
  const WatchedPoints watched = watched_points(mesh, nullptr, true);
  EXPECT_EQ(watched.text(), "8 points of the bedrock");
  std::set<std::string> names;
  for (const scene::Monitor &point : watched.points)
    {
      names.insert(point.name);
      for (const char c : point.name)
        EXPECT_TRUE(std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '.')
          << point.name;
    }
  EXPECT_EQ(names.size(), watched.points.size());
}



TEST(WatchedPoints, are_none_where_nothing_moves)
{
  const WatchedPoints watched = watched_points({}, nullptr, false);
  EXPECT_TRUE(watched.points.empty());
  EXPECT_EQ(watched.text(), "");
}
