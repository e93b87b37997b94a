// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/model/downhill.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
  using namespace hybrid;

  using Points = std::vector<Vec2>;

  const Points valley{{-80., 60.}, {0., 0.}, {40., 20.}}; ///< the left flank is higher

  /// A block 2 m high between two places along x of a surface that is straight there.
  Points on(const Points &surface, const double left, const double right)
  {
    const auto height = [&](const double x) {
      std::size_t k = 1;
      while (surface[k].x() < x)
        ++k;
      const Vec2 &a = surface[k - 1], &b = surface[k];
      return a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
    };
    const double l = height(left), r = height(right);
    return {{left, l}, {right, r}, {right, r + 2.}, {left, l + 2.}};
  }



  /// The left-right image.
  Points mirrored(Points points)
  {
    for (Vec2 &x : points)
      x.x() *= -1.;
    std::reverse(points.begin(), points.end());
    return points;
  }



  dda::Downhill downhill_of(const std::vector<Points> &blocks, const Points &surface)
  {
    scene::SectionMesh mesh;
    const auto         add = [&](const Vec2 &x) {
      mesh.nodes.push_back(x);
      return static_cast<int>(mesh.nodes.size()) - 1;
    };
    for (const Points &block : blocks)
      {
        mesh.blocks.emplace_back();
        for (const Vec2 &x : block)
          mesh.blocks.back().push_back(add(x));
        mesh.block_region.push_back(0);
      }
    mesh.block_region_names = {"sliding_mass"};
    for (std::size_t k = 0; k < surface.size(); ++k)
      if (const int node = add(surface[k]); k > 0)
        mesh.lines["sliding_surface"].push_back({node - 1, node});
    return dda::build_model(mesh, test::block_parameters(30.), surface).downhill;
  }



  /// The signs of these blocks, and of the mirror image; their difference is a failure.
  std::vector<double> signs_of(const std::vector<Points> &blocks, const Points &surface)
  {
    std::vector<Points> others;
    for (const Points &block : blocks)
      others.push_back(mirrored(block));
    const std::vector<double> sign  = downhill_of(blocks, surface).sign,
                              other = downhill_of(others, mirrored(surface)).sign;
    for (std::size_t b = 0; b < sign.size(); ++b)
      EXPECT_EQ(other[b], -sign[b]) << "block " << b;
    return sign;
  }

  using Signs = std::vector<double>;
} // namespace



TEST(Downhill, a_slide_falls_into_the_valley_whichever_flank_is_higher)
{
  EXPECT_EQ(signs_of({on(valley, 10., 14.)}, valley), Signs({-1.}));
  EXPECT_EQ(signs_of({on(valley, -14., -10.)}, valley), Signs({1.}));
}



TEST(Downhill, slides_on_both_flanks_face_each_other)
{
  const dda::Downhill two = downhill_of({on(valley, 10., 14.), on(valley, -14., -10.)}, valley);
  EXPECT_EQ(two.sign, Signs({-1., 1.}));
  EXPECT_EQ(two.slide, std::vector<int>({0, 1}));
  EXPECT_EQ(two.shared(), 0.);
  EXPECT_FALSE(two.is_level());
}



TEST(Downhill, blocks_that_touch_are_one_slide_down_to_a_toe_that_rises)
{
  const Points surface{{-20., 2.}, {0., 0.}, {40., 20.}};
  // the second is a crack of 1 cm away, the third stands on the first
  const std::vector<Points> blocks{on(surface, -4., 0.),
                                   on(surface, 0.01, 6.),
                                   {{-3., 2.3}, {-1., 2.1}, {-2., 4.}}};
  EXPECT_EQ(signs_of(blocks, surface), Signs({-1., -1., -1.}));
  EXPECT_EQ(downhill_of(blocks, surface).slide, std::vector<int>({0, 0, 0}));
  EXPECT_EQ(signs_of({blocks[0], on(surface, 1., 6.)}, surface), Signs({1., -1.})); // apart
}



TEST(Downhill, in_a_bowl_the_lower_end_counts)
{
  const Points bowl{{-20., 10.}, {0., 0.}, {20., 10.}};
  EXPECT_EQ(signs_of({on(bowl, -12., 0.), on(bowl, 0., 10.)}, bowl), Signs({1., 1.}));
  EXPECT_EQ(signs_of({on(bowl, -10., 0.), on(bowl, 0., 10.)}, bowl), Signs({0., 0.}));
}



TEST(Downhill, a_level_stretch_falls_as_the_surface_beside_it_does)
{
  const Points bench{{-20., 0.}, {0., 8.}, {10., 8.}, {30., 20.}};
  EXPECT_EQ(signs_of({on(bench, 2., 6.)}, bench), Signs({-1.}));
  const Points foot{{-20., 0.}, {0., 0.}, {30., 20.}};
  EXPECT_EQ(signs_of({on(foot, -8., -4.)}, foot), Signs({-1.}));
  const Points floor{{-20., 9.}, {0., 0.}, {10., 0.}, {30., 20.}},
    top{{-20., -9.}, {0., 0.}, {10., 0.}, {30., -20.}};
  EXPECT_EQ(signs_of({on(floor, 2., 6.)}, floor), Signs({0.}));
  EXPECT_EQ(signs_of({on(top, 2., 6.)}, top), Signs({0.}));
  EXPECT_TRUE(downhill_of({on(top, 2., 6.)}, top).is_level());
}



TEST(Downhill, is_that_of_the_ground_not_of_a_block_that_leans)
{
  const Points ground{{-20., 0.}, {20., 0.}},
    leaning{{0., 0.}, {1., 0.08}, {0.5, 6.}, {-0.5, 5.92}};
  EXPECT_EQ(signs_of({leaning}, ground), Signs({0.}));
}



TEST(Downhill, level_slides_and_those_in_the_air_go_with_all_others)
{
  const Points floor{{-20., 9.}, {0., 0.}, {10., 0.}, {30., 20.}},
    flies{{20., 30.}, {22., 30.}, {21., 32.}};
  EXPECT_EQ(signs_of({on(floor, 2., 6.), flies, on(floor, 14., 18.)}, floor),
            Signs({-1., -1., -1.}));
  EXPECT_EQ(signs_of({on(floor, -6., -2.), flies, on(floor, 14., 18.)}, floor),
            Signs({1., 0., -1.}));
}
