// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/polygon.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using Outline = std::vector<Vec2>;


  PolygonMoments moments(const Outline &p)
  {
    return polygon_moments(p.data(), static_cast<int>(p.size()));
  }

  bool simple(const Outline &p)
  {
    return is_simple(p.data(), static_cast<int>(p.size()));
  }

  TEST(PolygonMoments, RectangleClosedForm)
  {
    const PolygonMoments m = moments({{1., 2.}, {4., 2.}, {4., 4.}, {1., 4.}});
    EXPECT_DOUBLE_EQ(m.area, 6.);
    EXPECT_DOUBLE_EQ(m.centroid.x(), 2.5);
    EXPECT_DOUBLE_EQ(m.centroid.y(), 3.);
    EXPECT_NEAR(m.sxx, 2. * 27. / 12., 1e-13); // h b^3 / 12
    EXPECT_NEAR(m.syy, 3. * 8. / 12., 1e-13);
    EXPECT_NEAR(m.sxy, 0., 1e-13);
  }

  TEST(PolygonMoments, RightTriangleClosedForm)
  {
    const PolygonMoments m = moments({{0., 0.}, {3., 0.}, {0., 2.}});
    EXPECT_DOUBLE_EQ(m.area, 3.);
    EXPECT_NEAR(m.sxx, 27. * 2. / 36., 1e-14);           // b^3 h / 36
    EXPECT_NEAR(m.syy, 3. * 8. / 36., 1e-14);            // b h^3 / 36
    EXPECT_NEAR(m.sxy, -3. * 3. * 2. * 2. / 72., 1e-14); // -b^2 h^2 / 72
  }

  TEST(PolygonMoments, NonConvexEqualsSumOfParts)
  {
    // an L: square 2 x 2 without its upper right quarter
    const PolygonMoments m = moments({{0., 0.}, {2., 0.}, {2., 1.}, {1., 1.}, {1., 2.}, {0., 2.}});
    EXPECT_DOUBLE_EQ(m.area, 3.);
    EXPECT_NEAR(m.centroid.x(), 5. / 6., 1e-15);
    // 2x2 square minus the quarter, about the corner, then Steiner
    const double about_corner = 16. / 3. - 7. / 3.;
    EXPECT_NEAR(m.sxx, about_corner - 3. * 25. / 36., 1e-14);
    EXPECT_NEAR(m.sxy, (4. - 2.25) - 3. * 25. / 36., 1e-14);
  }

  TEST(PolygonMoments, FarFromTheOriginLosesNoDigits)
  {
    const Vec2    far(4.0e5, 3.3e6); // map coordinates
    const Outline near{{0., 0.}, {0.5, 0.25}, {0.125, 1.}};
    Outline       moved = near;
    for (Vec2 &p : moved)
      p += far;
    const PolygonMoments a = moments(near), b = moments(moved);
    EXPECT_NEAR(b.sxx, a.sxx, 1e-9 * a.sxx);
    EXPECT_NEAR(b.sxy, a.sxy, 1e-9 * a.sxx);
    EXPECT_NEAR(b.area, a.area, 1e-15);
  }

  TEST(IsSimple, AcceptsConvexAndNonConvexRefusesTheRest)
  {
    EXPECT_TRUE(simple({{0., 0.}, {1., 0.}, {0., 1.}}));
    EXPECT_TRUE(simple({{0., 0.}, {2., 0.}, {2., 1.}, {1., 0.5}, {0., 1.}}));
    EXPECT_TRUE(simple({{0., 0.}, {1., 0.}, {2., 0.}, {1., 1.}})); // a straight vertex is allowed
    EXPECT_FALSE(simple({{0., 0.}, {1., 1.}, {1., 0.}, {0., 1.}})) << "bow tie";
    EXPECT_FALSE(simple({{0., 0.}, {1., 0.}})) << "two vertices";
    EXPECT_FALSE(simple({{0., 0.}, {1., 0.}, {1., 0.}, {0., 1.}})) << "edge of no length";
    EXPECT_FALSE(simple({{0., 0.}, {2., 0.}, {1., 0.}, {1., 1.}})) << "spike";
    EXPECT_FALSE(simple({{0., 0.}, {2., 0.}, {2., 2.}, {1., 0.}, {0., 2.}})) << "touches itself";
  }

  TEST(Distance, OutlineAndContains)
  {
    const Outline l{{0., 0.}, {2., 0.}, {2., 1.}, {1., 1.}, {1., 2.}, {0., 2.}};
    EXPECT_TRUE(contains(l.data(), 6, {0.5, 1.5}));
    EXPECT_FALSE(contains(l.data(), 6, {1.5, 1.5}));
    EXPECT_FALSE(contains(l.data(), 6, {-1., 0.5}));
    EXPECT_DOUBLE_EQ(distance_to_outline(l.data(), 6, {0.5, 1.5}), 0.5);
    EXPECT_DOUBLE_EQ(distance_to_outline(l.data(), 6, {1.25, 1.5}), 0.25);
    EXPECT_DOUBLE_EQ(distance_to_outline(l.data(), 6, {5., -4.}), 5.);
  }
} // namespace
