// SPDX-License-Identifier: GPL-3.0-or-later
// Impacts: the energy audit closes, and no scheme ever gains energy: on the base and on a block,
// normal and oblique, on a corner and flat, slow and fast, with gravity and without.
#include "block_scenes.h"

#include <hybrid/dda/step/block_energy.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  struct Impact
  {
    double speed;     ///< [m/s]
    double obliquity; ///< of the velocity from the normal [deg]
    double tilt;      ///< of the block; 0 is flat [deg]
    bool   on_block;  ///< on a second block that rests on the base

    std::string name() const
    {
      return std::to_string(speed) + " m/s, " + std::to_string(obliquity) + " deg oblique, tilt " +
             std::to_string(tilt) + " deg, on " + (on_block ? "block" : "base");
    }
  };



  std::vector<Impact> family()
  {
    std::vector<Impact> list;
    for (const double speed : {0.1, 1., 5., 20.})
      for (const double obliquity : {0., 30.})
        for (const double tilt : {0., 20.})
          for (const bool on_block : {false, true})
            list.push_back({speed, obliquity, tilt, on_block});
    return list;
  }



  scene::SectionMesh one_block(const std::vector<Vec2> &outline)
  {
    scene::SectionMesh mesh;
    mesh.nodes              = outline;
    mesh.blocks             = {{0, 1, 2, 3}};
    mesh.block_region       = {0};
    mesh.block_region_names = {"sliding_mass"};
    return mesh;
  }



  /// Left and right exchanged; outlines go round, and the ground from left to right, as before.
  void mirror(scene::SectionMesh &mesh, std::vector<Vec2> &ground)
  {
    for (std::vector<Vec2> *nodes : {&mesh.nodes, &ground})
      {
        for (Vec2 &x : *nodes)
          x.x() = -x.x();
        std::reverse(nodes->begin(), nodes->end());
      }
  }



  /// A square just above what it will hit; the target square stands a little above the base too.
  scene::SectionMesh impact_mesh(const Impact &impact)
  {
    constexpr double   gap  = 1e-3; // m
    const double       tilt = impact.tilt * M_PI / 180.;
    scene::SectionMesh mesh = square_blocks(1, 1, 1., tilt);
    for (Vec2 &x : mesh.nodes)
      x += Vec2(impact.on_block ? 0.1 : 0., gap + (impact.on_block ? 1. : 0.));
    if (impact.on_block)
      {
        const scene::SectionMesh target = square_blocks(1, 1);
        mesh.nodes.insert(mesh.nodes.end(), target.nodes.begin(), target.nodes.end());
        mesh.blocks.push_back({4, 5, 7, 6});
        mesh.block_region.push_back(0);
      }
    return mesh;
  }



  /// What the blocks hold: kinetic energy, the scheme's own acceleration term, strain, springs, and
  /// height [J/m].
  double held(const dda::BlockEnergy &e)
  {
    return e.kinetic + e.strain + e.springs + e.gravity;
  }



  /**
   * At no step does the held energy exceed the one at the start, by more than
   * 1e-6 of the energy exchanged (the larger of the kinetic energy at the start
   * and the largest change of height so far); the audit closes within 1 % of it.
   */
  void check(const Impact &impact, const char *preset, const double gravity)
  {
    scene::SceneParameters p          = block_parameters(30.);
    p.time.newmark                    = Newmark::preset(preset);
    p.time.maximum_displacement_ratio = 0.05;
    p.environment.gravity             = gravity;
    FixedBaseRun run(impact_mesh(impact), p, straight_foundation(0., 20., 20.));
    const double angle                     = impact.obliquity * M_PI / 180.;
    run.state.blocks[0].velocity.head<2>() = impact.speed * Vec2(std::sin(angle), -std::cos(angle));
    run.state.energy                       = dda::stored_energy(run.model, run.state);

    const double kinetic  = run.state.energy.kinetic;
    const double balance  = run.state.energy.balance();
    const double duration = impact.speed < 1. ? 0.4 : 0.2;
    const double dt    = std::min(1e-3, 5e-3 / impact.speed); // half a percent of its size per step
    const double start = held(run.state.energy);
    double       largest = start, drift = 0., exchanged = kinetic;
    while (run.state.time < duration)
      {
        ASSERT_TRUE(run.advance(dt, 10)) << impact.name() << ' ' << preset;
        largest   = std::max(largest, held(run.state.energy));
        drift     = std::max(drift, std::abs(run.state.energy.balance() - balance));
        exchanged = std::max(exchanged, std::abs(run.state.energy.gravity));
      }
    EXPECT_LE(largest - start, 1e-6 * exchanged) << impact.name() << ' ' << preset;
    EXPECT_LE(drift, 0.01 * exchanged) << impact.name() << ' ' << preset;
    if (gravity == 0.)
      {
        EXPECT_LE(run.state.energy.kinetic, kinetic) << impact.name() << ' ' << preset;
      }
  }



  void check_family(const char *preset)
  {
    for (const double gravity : {9.81, 0.})
      for (const Impact &impact : family())
        check(impact, preset, gravity);
  }
} // namespace



TEST(BlockImpact, dissipative_scheme_gains_no_energy)
{
  check_family("dissipative");
}



TEST(BlockImpact, filtered_scheme_gains_no_energy)
{
  check_family("filtered");
}



TEST(BlockImpact, constant_acceleration_scheme_of_shi_gains_no_energy)
{
  check_family("shi");
}



TEST(BlockImpact, trapezoidal_scheme_gains_no_energy)
{
  check_family("trapezoidal");
}



// The spring of a face that overlaps by little is no softer than a corner's: it would go in far,
// get longer as the block turns, and give back more than it took.
TEST(BlockImpact, corner_just_below_the_top_of_a_wall_gains_no_energy)
{
  for (const double height : {1e-5, 1e-4, 1e-3, 1e-2, 0.1}) // of the wall above the corner [m]
    for (const double side : {1., -1.})                     // and mirrored
      {
        scene::SectionMesh mesh = one_block({{-6.05, 0.}, {-0.05, 0.}, {-0.05, 0.6}, {-6.05, 0.6}});
        std::vector<Vec2>  ground{{-40., -4.}, {-0.001, -4.}, {0., height}, {40., height}};
        if (side < 0.)
          mirror(mesh, ground);
        FixedBaseRun run(mesh, block_parameters(10., 5e9, 2500.), ground);
        run.state.blocks[0].velocity.x() = 3. * side;
        run.state.energy                 = dda::stored_energy(run.model, run.state);
        const double kinetic             = run.state.energy.kinetic;
        ASSERT_TRUE(run.run(0.2, 1e-3)) << height;
        EXPECT_LE(run.state.energy.kinetic, 0.5 * kinetic) << height << ' ' << side;
        EXPECT_LE(std::abs(run.state.energy.balance() - kinetic), 1e-4 * kinetic) << height;
      }
}
