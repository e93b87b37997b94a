// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/cell_grid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  std::vector<int> brute_force(const std::vector<Box> &boxes, const Vec2 &p)
  {
    std::vector<int> found;
    for (std::size_t b = 0; b < boxes.size(); ++b)
      if ((p.array() >= boxes[b].lower.array()).all() &&
          (p.array() <= boxes[b].upper.array()).all())
        found.push_back(static_cast<int>(b));
    return found;
  }

  std::vector<int> sorted_find(const CellGrid &grid, const Vec2 &p)
  {
    std::vector<int> found;
    grid.find(p, found);
    std::sort(found.begin(), found.end());
    return found;
  }

  TEST(CellGrid, EqualsBruteForceForBoxesOfAllSizes)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> place(-50., 50.), size(0.01, 4.);
    std::vector<Box>                       boxes;
    for (int i = 0; i < 400; ++i)
      {
        const Vec2 p(place(random), place(random));
        boxes.push_back({p, p + Vec2(size(random), size(random))});
      }
    boxes.push_back({{-60., -60.}, {60., 0.}});          // a rock mass
    boxes.push_back({{1e7, 1e7}, {1e7 + 1., 1e7 + 1.}}); // a block that left
    CellGrid grid;
    grid.build(boxes);
    for (int i = 0; i < 2000; ++i)
      {
        const Vec2 p(place(random), place(random));
        EXPECT_EQ(sorted_find(grid, p), brute_force(boxes, p));
      }
    EXPECT_EQ(sorted_find(grid, {1e7 + 0.5, 1e7 + 0.5}), (std::vector<int>{401}));
    EXPECT_LT(grid.cell_size(), 5.);
  }

  TEST(CellGrid, BordersBelongToTheBox)
  {
    CellGrid grid;
    grid.build({{{0., 0.}, {1., 1.}}, {{1., 0.}, {2., 1.}}});
    EXPECT_EQ(sorted_find(grid, {1., 1.}), (std::vector<int>{0, 1}));
    EXPECT_EQ(sorted_find(grid, {0., 0.}), (std::vector<int>{0}));
    EXPECT_EQ(sorted_find(grid, {2., 1.}), (std::vector<int>{1}));
    EXPECT_TRUE(sorted_find(grid, {2.5, 1.}).empty());
  }

  TEST(CellGrid, EmptyAndNotFinite)
  {
    CellGrid grid;
    grid.build({});
    EXPECT_TRUE(sorted_find(grid, {0., 0.}).empty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    grid.build({{{0., 0.}, {1., 1.}}, {{nan, nan}, {nan, nan}}});
    EXPECT_EQ(sorted_find(grid, {0.5, 0.5}), (std::vector<int>{0}));
    EXPECT_TRUE(sorted_find(grid, {nan, 0.}).empty());
  }
} // namespace
