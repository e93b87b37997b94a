// SPDX-License-Identifier: GPL-3.0-or-later
// A block on a plane of 30 degrees: slides as the closed form says, or rests. Blocks on the level
// rest.
#include "block_scenes.h"

#include <hybrid/dda/statics/static_stage.h>

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
    FixedBaseRun run(square_blocks(1, 1, 1., slope),
                     p,
                     straight_foundation(slope, 10., 5., pieces));
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

  /// A slide on a belt with cohesion, until no corner is on the belt any more.
  struct BeltSlide
  {
    double distance  = 0.; ///< down the slope [m]
    double speed     = 0.; ///< then [m/s]
    double expected  = 0.; ///< speed after that distance [m/s]
    double drive     = 0.; ///< acceleration without cohesion [m/s2]
    double full      = 0.; ///< what the cohesion of the whole edge takes of it [m/s2]
    bool   converged = false;
  };

  /// @param corners the first two on the plane, bonded by a belt from x = 0 to the edge's length L.
  ///
  /// The joint bears c L for a tenth of L; then it is a contact, whose cohesion acts on the L - s
  /// that are left of the bonded area.
  BeltSlide slide_on_belt(const std::vector<Vec2> &corners,
                          const double             cohesion,
                          const int                pieces,
                          const double             duration)
  {
    const double           length = (corners[1] - corners[0]).norm(), friction = 15.;
    scene::SceneParameters p             = block_parameters(friction);
    p.materials["belt"]                  = p.materials["rock"];
    p.materials["belt"].name             = "belt";
    p.materials["belt"].cohesion         = cohesion;
    p.materials["belt"].tensile_strength = 1e6; // it does not open at the heel
    p.blocks.belt_material               = "belt";
    p.blocks.softening_slip              = 0.01;
    p.blocks.damping_ratio               = 0.05;
    scene::SectionMesh mesh              = block_on_plane(corners);
    mesh.lines["sliding_surface"].push_back({0, 1});
    const Vec2        down = -Vec2(std::cos(slope), std::sin(slope));
    std::vector<Vec2> base{12. * down, mesh.nodes[0]};
    for (int k = 1; k < pieces; ++k)
      base.push_back(mesh.nodes[0] + double(k) / pieces * (mesh.nodes[1] - mesh.nodes[0]));
    base.insert(base.end(), {mesh.nodes[1], -8. * down});
    FixedBaseRun run(mesh, p, base);
    EXPECT_TRUE(dda::settle(run.model, run.state, true).equilibrium);
    const Vec2 start = run.state.blocks[0].centroid;

    BeltSlide result;
    result.converged = run.run(duration, 1e-3);
    result.distance  = (run.state.blocks[0].centroid - start).dot(down);
    result.speed     = run.state.blocks[0].velocity.head<2>().dot(down);
    result.drive   = 9.81 * (std::sin(slope) - std::cos(slope) * std::tan(friction * M_PI / 180.));
    result.full    = cohesion * length / run.model.blocks[0].mass;
    const double s = std::min(result.distance, length);
    const double bound = std::min(s, 0.1 * length), left = length - s, begun = length - bound;
    const double work = result.full * (bound + 0.5 * (begun * begun - left * left) / length);
    result.expected   = std::sqrt(std::max(0., 2. * (result.drive * result.distance - work)));
    return result;
  }

  const double closed_form =
    0.5 * 9.81 * (std::sin(slope) - std::cos(slope) * std::tan(15. * M_PI / 180.));

  /// Largest displacement of a centroid in a loose column on the level [m].
  double moved_at_rest(const int rows, const double duration, const double dt, const char *preset)
  {
    scene::SceneParameters p = block_parameters(30.);
    p.time.newmark           = Newmark::preset(preset);
    FixedBaseRun run(square_blocks(1, rows), p, straight_foundation(0., 2., 3.));
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
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    EXPECT_NEAR(slide(15., 1e-3, 1, true, preset), closed_form, 1e-4 * closed_form) << preset;
}



// Each place of the base below the sole is a contact: with them the springs of the sole resist its
// rocking a little differently, which is all that a block on a straight base knows of them.
TEST(BlockIncline, does_not_feel_the_seams_of_the_base)
{
  const double whole = slide(15., 1e-3, 1, true);
  for (const int pieces : {15, 47, 150})
    EXPECT_NEAR(slide(15., 1e-3, pieces, true), whole, 1e-4 * whole) << pieces;
}



TEST(BlockIncline, cohesion_of_a_belt_acts_on_what_is_left_of_the_bonded_area)
{
  const std::vector<std::vector<Vec2>> blocks{
    {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}},   // the square
    {{0., 0.}, {3., 0.}, {3., 3.}, {0., 3.}},   // a larger one
    {{0., 0.}, {2., 0.}, {2., 0.5}, {0., 0.5}}, // flat
    {{0., 0.}, {2., 0.}, {1., 1.2}},            // triangles
    {{0., 0.}, {2., 0.}, {1.6, 0.5}},
  };
  for (const std::vector<Vec2> &corners : blocks)
    for (const int pieces : {1, 7})
      for (const double duration : {0.5, 0.8, 1.4})
        {
          const double    height = corners[2].y();
          const BeltSlide found  = slide_on_belt(corners, 1.5e3 * height, pieces, duration);
          EXPECT_TRUE(found.converged);
          EXPECT_GT(found.distance, 0.02);
          EXPECT_NEAR(found.speed, found.expected, 0.01 * found.drive * duration)
            << corners.size() << " corners, height " << height << ", pieces " << pieces << ", slid "
            << found.distance;
        }
}



TEST(BlockIncline, cohesion_of_a_belt_holds_a_block_up_to_its_closed_form)
{
  // c L = m g (sin a - cos a tan phi) is the limit.
  const std::vector<Vec2> triangle{{0., 0.}, {2., 0.}, {1., 1.2}};
  const double            drive = 2. * closed_form;                      // m/s2
  const double            limit = 2220. * (0.5 * 2. * 1.2) * drive / 2.; // Pa
  EXPECT_LT(std::abs(slide_on_belt(triangle, 1.01 * limit, 1, 1.).distance), 1e-3);
  EXPECT_GT(slide_on_belt(triangle, 0.95 * limit, 1, 1.).distance, 0.02 * drive / 2.);
}



// A block that lands where no belt was slides as friction alone says, though a belt is elsewhere.
TEST(BlockIncline, debris_on_a_slope_has_friction_only)
{
  const double           angle = 20. * M_PI / 180., phi = 14.7;
  const Vec2             along(std::cos(angle), std::sin(angle)), up(-along.y(), along.x());
  scene::SceneParameters p             = block_parameters(phi);
  p.materials["belt"]                  = p.materials["rock"];
  p.materials["belt"].name             = "belt";
  p.materials["belt"].cohesion         = 19.76e3;
  p.materials["belt"].tensile_strength = 15e3;
  p.blocks.belt_material               = "belt";
  scene::SectionMesh mesh;
  for (const double x : {0., 20.}) // debris, and a block with a belt farther up
    {
      for (const Vec2 &corner : {Vec2(0., 0.), Vec2(2., 0.), Vec2(2., 1.), Vec2(0., 1.)})
        mesh.nodes.push_back((x + corner.x()) * along + corner.y() * up);
      const int n = static_cast<int>(mesh.nodes.size()) - 4;
      mesh.blocks.push_back({n, n + 1, n + 2, n + 3});
      mesh.block_region.push_back(0);
    }
  mesh.block_region_names = {"sliding_mass"};
  mesh.lines["sliding_surface"].push_back({4, 5});
  FixedBaseRun run(mesh, p, {-40. * along, mesh.nodes[4], mesh.nodes[5], 30. * along});
  EXPECT_TRUE(dda::settle(run.model, run.state, true).equilibrium);
  run.state.blocks[0].velocity.head<2>() = -5. * along;
  const Vec2 start = run.state.blocks[0].centroid, held = run.state.blocks[1].centroid;
  EXPECT_TRUE(run.run(2., 1e-3));
  const double a = 9.81 * (std::sin(angle) - std::cos(angle) * std::tan(phi * M_PI / 180.));
  EXPECT_NEAR(-along.dot(run.state.blocks[0].centroid - start), 10. + 2. * a, 0.01); // 11.88 m
  EXPECT_LT((run.state.blocks[1].centroid - held).norm(), 1e-3);
}



TEST(BlockIncline, rests_above_the_slope_angle_at_any_step)
{
  for (const double dt : {1e-4, 1e-3, 2e-3})
    EXPECT_LT(std::abs(slide(31., dt, 1, false)), 1e-6) << dt;
}



TEST(BlockIncline, block_on_the_level_rests_in_every_scheme_at_any_step)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    for (const double dt : {1e-4, 1e-3, 2e-3})
      EXPECT_LT(moved_at_rest(1, 10., dt, preset), 1e-6) << preset << ' ' << dt;
}



TEST(BlockIncline, stack_of_five_rests_in_every_scheme_at_any_step)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    for (const double dt : {1e-4, 1e-3, 2e-3})
      EXPECT_LT(moved_at_rest(5, 1., dt, preset), 1e-6) << preset << ' ' << dt;
}
