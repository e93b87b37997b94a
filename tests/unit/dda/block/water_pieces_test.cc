// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/water_pieces.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  Water with_line(const double level, const std::vector<Vec2> &points)
  {
    Water water{Water::Action::buoyancy, level, 9810.};
    water.line = std::make_shared<const scene::LinearTable>(scene::LinearTable{points});
    return water;
  }



  std::vector<WaterPiece> pieces_of(const Water &water, const double first, const double last)
  {
    std::vector<WaterPiece> found;
    WaterPieces             pieces(water, first, last);
    while (const std::optional<WaterPiece> piece = pieces.next())
      found.push_back(*piece);
    return found;
  }



  const std::vector<Vec2> ridge = {{0., 1.}, {2., 5.}, {6., 1.}};
} // namespace



TEST(WaterPieces, level_is_one)
{
  const auto found = pieces_of({Water::Action::buoyancy, 7., 9810.}, -3., 4.);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(found[0].left, -1e200);
  EXPECT_GT(found[0].right, 1e200);
  EXPECT_EQ(found[0].height(123.), 7.);
  EXPECT_EQ(found[0].number, WaterPiece::of_level);
}



TEST(WaterPieces, those_above_the_range_and_no_other)
{
  const Water water = with_line(-1e300, ridge);
  EXPECT_EQ(pieces_of(water, -2., -1.).size(), 1u);
  EXPECT_EQ(pieces_of(water, 0.5, 1.5).size(), 1u);
  EXPECT_EQ(pieces_of(water, 0.5, 2.5).size(), 2u);
  EXPECT_EQ(pieces_of(water, -1., 7.).size(), 4u);
  EXPECT_EQ(pieces_of(water, 8., 9.).size(), 1u);
  EXPECT_EQ(pieces_of(water, 2., 2.).size(), 1u); // a place where two meet
}



TEST(WaterPieces, are_the_higher_one_of_level_and_line_without_gaps)
{
  for (const double level : {-1e300, 0., 1., 3., 5., 8.})
    {
      const Water water = with_line(level, ridge);
      const auto  found = pieces_of(water, -1., 7.);
      for (std::size_t k = 0; k + 1 < found.size(); ++k)
        {
          EXPECT_EQ(found[k].right, found[k + 1].left) << level;
          EXPECT_NEAR(found[k].height(found[k].right), found[k + 1].height(found[k].right), 1e-12);
        }
      for (double x = -1.; x <= 7.; x += 0.125)
        {
          const auto piece = std::find_if(found.begin(), found.end(), [&](const WaterPiece &p) {
            return p.left <= x && x <= p.right;
          });
          ASSERT_NE(piece, found.end());
          EXPECT_NEAR(piece->height(x), std::max(level, (*water.line)(x)), 1e-12) << level;
        }
    }
}
