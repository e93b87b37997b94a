// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/surface_line.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  /// Points that wander to the right.
  std::vector<Vec2> rough_line(std::mt19937 &random, const int n)
  {
    std::uniform_real_distribution<double> step(0., 1.), height(-1., 1.);
    std::vector<Vec2>                      points(1, Vec2(0., 0.));
    while (static_cast<int>(points.size()) < n)
      points.push_back(points.back() + Vec2(step(random), height(random)));
    return points;
  }



  /// Distance from the line between its ends.
  double distance(const std::vector<Vec2> &points, const Vec2 &place)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      {
        const Vec2   along = points[k + 1] - points[k];
        const double at = std::clamp((place - points[k]).dot(along) / along.squaredNorm(), 0., 1.);
        least           = std::min(least, (place - points[k] - at * along).norm());
      }
    return least;
  }
} // namespace



TEST(SurfaceLine, finds_the_nearest_point_of_all_pieces)
{
  std::mt19937 random(7);
  for (const int n : {2, 3, 8, 100})
    {
      const std::vector<Vec2>                points = rough_line(random, n);
      const SurfaceLine                      line(points, false);
      std::uniform_real_distribution<double> x(0.2, points.back().x()), y(-3., 3.);
      for (int k = 0; k < 200; ++k)
        {
          const Vec2   place(x(random), y(random));
          const double found = (line.point_at(line.way_to(place)) - place).norm();
          EXPECT_LE(found, distance(points, place) + 1e-12); // beyond its ends it goes on
        }
    }
}



TEST(SurfaceLine, goes_on_beyond_its_ends_and_round_when_closed)
{
  const SurfaceLine open({{0., 0.}, {0., 0.}, {1., 0.}, {1., 1.}, {1., 1.}}, false);
  EXPECT_DOUBLE_EQ(open.way_to({-3., 0.5}), -3.);
  EXPECT_DOUBLE_EQ(open.way_to({2., 4.}), 5.);
  EXPECT_DOUBLE_EQ(open.way_to({0.25, -1.}), 0.25);
  EXPECT_LT((open.point_at(5.) - Vec2(1., 4.)).norm(), 1e-15);
  EXPECT_LT((open.point_at(-3.) - Vec2(-3., 0.)).norm(), 1e-15);

  const SurfaceLine closed({{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}}, true);
  EXPECT_DOUBLE_EQ(closed.way_to({-1., 0.25}), 3.75);
  EXPECT_DOUBLE_EQ(closed.between(3.75, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(closed.between(0.25, 3.75), -0.5);
  EXPECT_DOUBLE_EQ(closed.between(1., 2.5), 1.5);
}
