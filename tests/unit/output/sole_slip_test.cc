// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/output/sole_slip.h>
#include <hybrid/restart/archive.h>

#include <Eigen/Geometry>
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
      : model(dda::build_model(hybrid::test::square_blocks(2, 1, 2.),
                               hybrid::test::block_parameters(30.),
                               hybrid::test::straight_foundation(0., 1., 6., 7)))
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


  /// The block's vertices turned by an angle [rad] about a point.
  void turn(dda::Geometry &g, const double angle, const Vec2 &about)
  {
    const Eigen::Rotation2Dd rotation(angle);
    for (Vec2 &vertex : g.vertices)
      vertex = about + rotation * (vertex - about);
  }


  /// Slip of the one block of a model that a motion has carried away from where it was drawn.
  template <typename Motion>
  double slip_after(const dda::Model &model, const Motion &motion)
  {
    dda::DdaState state = dda::initial_state(model);
    SoleSlip      slip(&model);
    slip.set_reference(state);
    motion(state.geometry);
    return slip.values(state).at(0);
  }
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
  const dda::Model        model = dda::build_model(hybrid::test::square_blocks(1, 1, 2.),
                                            hybrid::test::block_parameters(30.),
                                            notched);
  dda::DdaState           state = dda::initial_state(model);
  SoleSlip                slip(&model);
  ASSERT_EQ(slip.n_soles(), 1);
  slip.set_reference(state);
  for (Vec2 &vertex : state.geometry.vertices)
    vertex.x() += 0.3;
  EXPECT_NEAR(slip.values(state)[0], 0.3, 1e-14);
}



/// A circular bowl: the tangent where the sole began would give R sin(angle), 8.4 m.
TEST(SoleSlip, on_a_circle_is_its_radius_times_the_angle)
{
  constexpr double  radius = 10., side = 1., pi = 3.14159265358979323846;
  const double      height = std::sqrt(radius * radius - 0.25 * side * side); // of the centre
  const Vec2        centre(0.5 * side, height);
  std::vector<Vec2> bowl;
  for (int k = 0; k <= 1440; ++k)
    bowl.push_back(centre + radius * Vec2(-std::cos(pi * k / 1440), -std::sin(pi * k / 1440)));
  const dda::Model model = dda::build_model(hybrid::test::square_blocks(1, 1, side),
                                            hybrid::test::block_parameters(30.),
                                            bowl);
  ASSERT_EQ(model.soles.size(), 1U);
  for (const double angle : {1e-4, 0.3, 1., -1.2})
    {
      const double slip = slip_after(model, [&](dda::Geometry &g) { turn(g, angle, centre); });
      EXPECT_NEAR(slip, radius * angle, 1e-4 * std::abs(radius * angle) + 1e-12);
    }
}



TEST(SoleSlip, goes_round_a_bend_and_straight_on_beyond_an_end)
{
  // Level, then 30 degrees down from x = 3 on for 2 m, where the surface ends.
  const double      c = std::cos(0.5235987755982988), s = 0.5;
  std::vector<Vec2> base{{-1., 0.}, {3., 0.}, {3. + 2. * c, -2. * s}};
  dda::Model        model = dda::build_model(hybrid::test::square_blocks(1, 1, 2.),
                                      hybrid::test::block_parameters(30.),
                                      base);
  const auto        moved = [&](const double way) { // with the middle of the sole on the surface
    return slip_after(model, [&](dda::Geometry &g) {
      if (way > 2.)
        turn(g, -0.5235987755982988, Vec2(1., 0.));
      for (Vec2 &vertex : g.vertices)
        vertex += way > 2. ? Vec2(2. + (way - 2.) * c, -(way - 2.) * s) : Vec2(way, 0.);
    });
  };
  for (const double sign : {1., -1.})
    {
      model.downhill.sign.assign(1, sign);
      for (const double way : {-5., 1e-9, 1., 2., 2.5, 4., 7.})
        EXPECT_NEAR(moved(way), sign * way, 1e-12) << way;
    }
}



TEST(SoleSlip, goes_on_from_a_checkpoint)
{
  TwoBlocks scene;
  SoleSlip  slip(&scene.model), copy(&scene.model);
  scene.move(0, Vec2(0.01, -0.02));
  slip.set_reference(scene.state);
  auto writer = restart::Archive::writer();
  slip.serialize(writer);
  auto reader = restart::Archive::reader(writer.content());
  copy.serialize(reader);
  EXPECT_TRUE(reader.at_end());
  scene.move(0, Vec2(0.3, 0.1));
  EXPECT_EQ(copy.values(scene.state), slip.values(scene.state));
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
  std::vector<Vec2> base = hybrid::test::straight_foundation(0., 1., 6., 7);
  for (const double x : {1., 3.}) // below the middle of each block
    {
      const auto at = std::find_if(base.begin(), base.end(), [&](const Vec2 &p) {
        return std::abs(p.x() - x) < 1e-9;
      });
      ASSERT_NE(at, base.end());
      base.insert(at, *at);
    }
  const dda::Model model = dda::build_model(hybrid::test::square_blocks(2, 1, 2.),
                                            hybrid::test::block_parameters(30.),
                                            base);
  dda::DdaState    state = dda::initial_state(model);
  SoleSlip         slip(&model);
  ASSERT_EQ(slip.n_soles(), 2);
  slip.set_reference(state);
  for (Vec2 &vertex : state.geometry.vertices)
    vertex += Vec2(0.5, 0.);
  for (const double value : slip.values(state))
    EXPECT_NEAR(value, 0.5, 1e-12);
}



TEST(SoleSlip, blocks_in_the_air_and_scenes_without_blocks_have_no_soles)
{
  const dda::Model model = dda::build_model(hybrid::test::square_blocks(1, 1, 2.),
                                            hybrid::test::block_parameters(30.),
                                            {Vec2(-1., -0.2), Vec2(3., -0.2)});
  EXPECT_EQ(SoleSlip(&model).n_soles(), 0);
  EXPECT_EQ(SoleSlip(nullptr).n_soles(), 0);
}
