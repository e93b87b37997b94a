// SPDX-License-Identifier: GPL-3.0-or-later
// A block on a plane of 30 degrees: slides as the closed form says, or rests. Blocks on the level
// rest.
#include "block_scenes.h"

#include <hybrid/dda/static_stage.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  constexpr double slope = 30. * M_PI / 180.;

  /// Distance down the slope after one second.
  double slide(const double friction_angle,
               const double dt,
               const int    pieces,
               const bool   held,
               const char  *preset = "dissipative")
  {
    scene::SceneParameters p = block_parameters(friction_angle);
    p.time.newmark           = Newmark::preset(preset);
    FixedBaseRun run(square_blocks(1, 1, 1., slope), p, straight_base(slope, 10., 5., pieces));
    EXPECT_TRUE(dda::settle(run.model, run.state, held).equilibrium);
    const Vec2 start = run.state.blocks[0].centroid;
    EXPECT_TRUE(run.run(1., dt));
    return -(run.state.blocks[0].centroid - start).dot(Vec2(std::cos(slope), std::sin(slope)));
  }

  /// Corners of a block on the plane; x along the plane, y away from it [m].
  scene::SectionMesh block_on_plane(const std::vector<Vec2> &corners)
  {
    scene::SectionMesh mesh;
    mesh.blocks.emplace_back();
    for (const Vec2 &p : corners)
      {
        mesh.blocks.back().push_back(static_cast<int>(mesh.nodes.size()));
        mesh.nodes.push_back(p.x() * Vec2(std::cos(slope), std::sin(slope)) +
                             p.y() * Vec2(-std::sin(slope), std::cos(slope)));
      }
    mesh.block_region       = {0};
    mesh.block_region_names = {"sliding_mass"};
    return mesh;
  }

  /// Acceleration of a slide with residual cohesion on an edge of @p length [m], by the distance in
  /// one second [m/s2]. Without damping some blocks flutter on their corners as they slide:
  /// friction that follows an oscillating normal force feeds the oscillation.
  double cohesive_acceleration(const std::vector<Vec2> &corners,
                               const double             cohesion,
                               const int                pieces,
                               double                  &closed_form)
  {
    scene::SceneParameters p              = block_parameters(15.);
    p.materials["rock"].residual_cohesion = cohesion;
    p.blocks.damping_ratio                = 0.05;
    FixedBaseRun run(block_on_plane(corners), p, straight_base(slope, 10., 5., pieces));
    EXPECT_TRUE(dda::settle(run.model, run.state, true).equilibrium);
    const Vec2 start = run.state.blocks[0].centroid;
    EXPECT_TRUE(run.run(1., 1e-3));
    closed_form = 9.81 * (std::sin(slope) - std::cos(slope) * std::tan(15. * M_PI / 180.)) -
                  cohesion * (corners[1] - corners[0]).norm() / run.model.blocks[0].mass;
    return -2. * (run.state.blocks[0].centroid - start).dot(Vec2(std::cos(slope), std::sin(slope)));
  }

  const double closed_form =
    0.5 * 9.81 * (std::sin(slope) - std::cos(slope) * std::tan(15. * M_PI / 180.));

  /// Largest displacement of a centroid in a loose column on the level [m].
  double moved_at_rest(const int rows, const double duration, const double dt, const char *preset)
  {
    scene::SceneParameters p = block_parameters(30.);
    p.time.newmark           = Newmark::preset(preset);
    FixedBaseRun run(square_blocks(1, rows), p, straight_base(0., 2., 3.));
    EXPECT_TRUE(dda::settle(run.model, run.state).equilibrium);
    const std::vector<dda::BlockState> start = run.state.blocks;
    EXPECT_TRUE(run.run(duration, dt));
    double moved = 0.;
    for (int b = 0; b < rows; ++b)
      {
        moved = std::max(moved, (run.state.blocks[b].centroid - start[b].centroid).norm());
        EXPECT_LT(run.state.blocks[b].velocity.head<2>().norm(), 1e-6) << preset << ' ' << dt;
      }
    return moved;
  }
} // namespace



TEST(BlockIncline, slides_as_the_closed_form_says)
{
  for (const char *preset : {"dissipative", "trapezoidal", "shi"})
    EXPECT_NEAR(slide(15., 1e-3, 1, true, preset), closed_form, 1e-4 * closed_form) << preset;
}



TEST(BlockIncline, does_not_feel_the_seams_of_the_base)
{
  const double whole = slide(15., 1e-3, 1, true);
  for (const int pieces : {15, 47, 150})
    EXPECT_NEAR(slide(15., 1e-3, pieces, true), whole, 1e-9 * whole) << pieces;
}



TEST(BlockIncline, residual_cohesion_acts_on_the_whole_edge_of_any_block)
{
  const std::vector<std::vector<Vec2>> blocks{
    {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}},   // the square
    {{0., 0.}, {3., 0.}, {3., 3.}, {0., 3.}},   // a larger one
    {{0., 0.}, {2., 0.}, {2., 0.5}, {0., 0.5}}, // flat
    {{0., 0.}, {2., 0.}, {1., 1.2}},            // triangles
    {{0., 0.}, {2., 0.}, {1.6, 0.5}},
  };
  for (const std::vector<Vec2> &corners : blocks)
    for (const int pieces : {1, 47})
      {
        const double height   = corners[2].y();
        double       expected = 0.;
        const double found    = cohesive_acceleration(corners, 1e3 * height, pieces, expected);
        EXPECT_GT(expected, 0.5);
        EXPECT_NEAR(found, expected, 1e-3 * expected)
          << corners.size() << " corners, height " << height << ", pieces " << pieces;
      }
}



TEST(BlockIncline, residual_cohesion_holds_a_block_up_to_its_closed_form)
{
  // c L = m g (sin a - cos a tan phi) is the limit.
  const std::vector<Vec2> triangle{{0., 0.}, {2., 0.}, {1., 1.2}};
  const double            drive = 2. * closed_form;                      // m/s2
  const double            limit = 2220. * (0.5 * 2. * 1.2) * drive / 2.; // Pa
  for (const double part : {0.95, 1.01})
    {
      double       expected = 0.;
      const double found    = cohesive_acceleration(triangle, part * limit, 1, expected);
      EXPECT_NEAR(expected, (1. - part) * drive, 1e-9);
      EXPECT_NEAR(found, std::max(0., expected), 1e-3 * drive) << part;
    }
}



TEST(BlockIncline, rests_above_the_slope_angle_at_any_step)
{
  for (const double dt : {1e-4, 1e-3, 2e-3})
    EXPECT_LT(std::abs(slide(31., dt, 1, false)), 1e-6) << dt;
}



TEST(BlockIncline, block_on_the_level_rests_in_every_scheme_at_any_step)
{
  for (const char *preset : {"dissipative", "trapezoidal", "shi"})
    for (const double dt : {1e-4, 1e-3, 2e-3})
      EXPECT_LT(moved_at_rest(1, 10., dt, preset), 1e-6) << preset << ' ' << dt;
}



TEST(BlockIncline, stack_of_five_rests_in_every_scheme_at_any_step)
{
  for (const char *preset : {"dissipative", "trapezoidal", "shi"})
    for (const double dt : {1e-4, 1e-3, 2e-3})
      EXPECT_LT(moved_at_rest(5, 1., dt, preset), 1e-6) << preset << ' ' << dt;
}
