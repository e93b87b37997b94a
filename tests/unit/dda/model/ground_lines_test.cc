// SPDX-License-Identifier: GPL-3.0-or-later
#include "bedrock_section.h"

#include <hybrid/dda/geometry/surface_line.h>
#include <hybrid/dda/model/ground_lines.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  using Points = std::vector<Vec2>;
} // namespace



TEST(GroundLines, are_the_outline_of_a_bedrock_of_blocks_and_the_foundation)
{
  const Model bedrock =
    build_model(test::layered_section(4, {1, 2}), test::bedrock_parameters("cells"), {});
  const std::vector<GroundLine> outline = ground_lines(bedrock);
  ASSERT_EQ(outline.size(), 1U);
  EXPECT_TRUE(outline[0].closed);
  const Points corners = outline[0].places(bedrock.initial.vertices, {});
  ASSERT_EQ(corners.size(), 14U);
  double area = 0.; // positive: counter-clockwise
  for (std::size_t k = 0; k < corners.size(); ++k)
    area += 0.5 * cross(corners[k], corners[(k + 1) % corners.size()]);
  EXPECT_DOUBLE_EQ(area, 12.);
  EXPECT_EQ(line_below(outline, {false, outline[0].points[5], 0, 0.}), 0);

  const Points base  = test::straight_foundation(0.3, 1., 6., 7);
  const Model  block = build_model(test::square_blocks(1, 1), test::block_parameters(30.), base);
  const std::vector<GroundLine> line = ground_lines(block);
  ASSERT_EQ(line.size(), 1U);
  EXPECT_FALSE(line[0].closed);
  EXPECT_EQ(line[0].places({}, base), Points(base.rbegin(), base.rend()));
}



// The ground is on the left of the line: below what runs towards -x.
TEST(GroundLines, cross_what_a_sole_bridges_and_no_gentle_bend)
{
  const Points notch{{4., 0.}, {1.3, 0.}, {1., -0.5}, {0.7, 0.}, {0., 0.}};
  EXPECT_EQ(without_dips(notch, 2.), Points({{4., 0.}, {1.3, 0.}, {0.7, 0.}, {0., 0.}}));
  EXPECT_EQ(without_dips(notch, 0.5), notch) << "a narrow sole falls into it";
  const Points step{{4., 1.}, {1., 1.}, {1., 0.}, {0., 0.}};
  EXPECT_EQ(without_dips(step, 0.9), step);
  const Points wide{{6., 0.}, {3., -1.}, {2., -1.}, {1.5, -1.}, {1., -1.}, {0., -1.}};
  EXPECT_EQ(without_dips(wide, 1.), wide);
  Points peak = notch;
  peak[2].y() = 0.5;
  EXPECT_EQ(without_dips(peak, 0.9), peak);
  Points kink, cut; // the corner of a valley with nodes every 0.1 m is cut alike on both sides
  for (int k = -20; k <= 20; ++k)
    kink.emplace_back(-0.1 * k, 0.05 * std::abs(k));
  for (int k = -20; k <= 20; ++k)
    if (std::abs(k) >= 5)
      cut.push_back(kink[k + 20]);
  EXPECT_EQ(without_dips(kink, 1.05), cut);
  Points bowl;
  for (int k = 0; k <= 90; ++k)
    bowl.push_back(10. * Vec2(std::cos(0.01 * k), -std::sin(0.01 * k)));
  EXPECT_EQ(without_dips(bowl, 3.), bowl);
}
