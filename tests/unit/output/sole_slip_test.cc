// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/output/sole_slip.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
  using namespace hybrid;
  using namespace hybrid::output;

  /// Two blocks of 2 m side by side on a level base of segments of 1 m from x = -1 to x = 6.
  struct TwoBlocks
  {
    TwoBlocks()
      : model(dda::build_model(test::square_blocks(2, 1, 2.),
                               test::block_parameters(30.),
                               test::straight_foundation(0., 1., 6., 7)))
      , state(dda::initial_state(model))
    {}

    void move(const int block, const Vec2 &by)
    {
      dda::Geometry &g = state.geometry;
      for (int v = g.offset[block]; v < g.offset[block + 1]; ++v)
        g.vertices[v] += by;
    }

    dda::Model    model;
    dda::DdaState state;
  };
} // namespace



TEST(SoleSlip, counts_from_rest_relative_to_the_ground)
{
  TwoBlocks scene;
  for (const double sign : {1., -1., 0.})
    {
      scene.model.downhill.sign.assign(2, sign);
      SoleSlip slip(&scene.model);
      ASSERT_EQ(slip.n_soles(), 2);
      EXPECT_NEAR(slip.length(0), 2., 1e-12);
      EXPECT_LT((slip.position(1) - Vec2(3., 0.)).norm(), 1e-12);
      scene.state = dda::initial_state(scene.model);
      scene.move(0, Vec2(0.01, -0.02)); // while it settles
      slip.set_reference(scene.state);
      EXPECT_EQ(slip.values(scene.state), std::vector<double>({0., 0.}));
      for (int k = 0; k < scene.model.n_foundation_nodes(); ++k)
        scene.state.foundation_displacement.segment<2>(2 * k) = Vec2(0.3, 0.1);
      scene.move(0, Vec2(0.5, 0.1));
      scene.move(1, Vec2(0.2, 0.1));
      const std::vector<double> now = slip.values(scene.state);
      const double              way = sign < 0. ? -1. : 1.;
      EXPECT_NEAR(now[0], way * 0.2, 1e-14);
      EXPECT_NEAR(now[1], way * -0.1, 1e-14);
      EXPECT_NEAR(slip.mean(now), way * 0.05, 1e-14);
      EXPECT_EQ(SoleSlip::farthest(now), 0);
    }
}



TEST(SoleSlip, of_a_sole_that_bridges_a_dip_is_that_of_a_point_beside_it)
{
  const std::vector<Vec2> notched{{-1., 0.}, {0.7, 0.}, {1., -0.5}, {1.3, 0.}, {4., 0.}};
  const dda::Model        model =
    dda::build_model(test::square_blocks(1, 1, 2.), test::block_parameters(30.), notched);
  dda::DdaState state = dda::initial_state(model);
  SoleSlip      slip(&model);
  ASSERT_EQ(slip.n_soles(), 1);
  slip.set_reference(state);
  for (Vec2 &vertex : state.geometry.vertices)
    vertex.x() += 0.3;
  EXPECT_NEAR(slip.values(state)[0], 0.3, 1e-14);
}



// Ground that stretches: the point under the sole counts, between the nodes beside it.
TEST(SoleSlip, follows_the_point_that_the_sole_lay_on)
{
  TwoBlocks scene;
  SoleSlip  slip(&scene.model);
  slip.set_reference(scene.state);
  for (int k = 0; k < scene.model.n_foundation_nodes(); ++k)
    scene.state.foundation_displacement[2 * k] = 0.01 * scene.model.initial.foundation_nodes[k].x();
  const std::vector<double> now = slip.values(scene.state);
  EXPECT_NEAR(now[0], -0.01 * 1., 1e-14);
  EXPECT_NEAR(now[1], -0.01 * 3., 1e-14);
}



/// Where a bedding plane ends on the sliding surface, the surface has a node for each of its sides.
TEST(SoleSlip, is_known_beside_two_nodes_at_one_place)
{
  std::vector<Vec2> base = test::straight_foundation(0., 1., 6., 7);
  for (const double x : {1., 3.}) // below the middle of each block
    {
      const auto at = std::find_if(base.begin(), base.end(), [&](const Vec2 &p) {
        return std::abs(p.x() - x) < 1e-9;
      });
      ASSERT_NE(at, base.end());
      base.insert(at, *at);
    }
  const dda::Model model =
    dda::build_model(test::square_blocks(2, 1, 2.), test::block_parameters(30.), base);
  dda::DdaState state = dda::initial_state(model);
  SoleSlip      slip(&model);
  ASSERT_EQ(slip.n_soles(), 2);
  slip.set_reference(state);
  for (Vec2 &vertex : state.geometry.vertices)
    vertex += Vec2(0.5, 0.);
  for (const double value : slip.values(state))
    EXPECT_NEAR(value, 0.5, 1e-12);
}



TEST(SoleSlip, blocks_in_the_air_and_scenes_without_blocks_have_no_soles)
{
  const dda::Model model = dda::build_model(test::square_blocks(1, 1, 2.),
                                            test::block_parameters(30.),
                                            {Vec2(-1., -0.2), Vec2(3., -0.2)});
  EXPECT_EQ(SoleSlip(&model).n_soles(), 0);
  EXPECT_EQ(SoleSlip(nullptr).n_soles(), 0);
}
