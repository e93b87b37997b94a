// SPDX-License-Identifier: GPL-3.0-or-later
// Impacts: the energy audit closes, and the damped schemes never gain energy: on the base and on a
// block, normal and oblique, on a corner and flat, slow and fast.
#include "block_scenes.h"

#include <hybrid/dda/block_energy.h>

#include <gtest/gtest.h>

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



  void check(const Impact &impact, const char *preset, const bool gains_nothing)
  {
    scene::SceneParameters p          = block_parameters(30.);
    p.time.newmark                    = Newmark::preset(preset);
    p.time.maximum_displacement_ratio = 0.05;
    FixedBaseRun run(impact_mesh(impact), p, straight_base(0., 20., 20.));
    const double angle                     = impact.obliquity * M_PI / 180.;
    run.state.blocks[0].velocity.head<2>() = impact.speed * Vec2(std::sin(angle), -std::cos(angle));
    for (dda::BlockState &block : run.state.blocks)
      block.acceleration[1] = -9.81;
    run.state.energy     = dda::held_energy(run.model, run.state);
    const double kinetic = run.state.energy.kinetic, start = run.state.energy.balance();
    double       largest = 0., drift = 0., exchanged = kinetic;
    const double duration = impact.speed < 1. ? 0.4 : 0.2;
    const double dt = std::min(1e-3, 5e-3 / impact.speed); // half a percent of its size per step
    while (run.state.time < duration)
      {
        ASSERT_TRUE(run.advance(dt, 10)) << impact.name() << ' ' << preset;
        const dda::BlockEnergy &e = run.state.energy;
        largest                   = std::max(largest, e.kinetic + e.strain + e.springs + e.gravity);
        drift                     = std::max(drift, std::abs(e.balance() - start));
        exchanged                 = std::max(exchanged, std::abs(e.gravity));
      }
    if (gains_nothing)
      {
        EXPECT_LE(largest, 1.02 * kinetic) << impact.name() << ' ' << preset;
      }
    EXPECT_LE(drift, 0.01 * exchanged) << impact.name() << ' ' << preset;
  }
} // namespace



TEST(BlockImpact, dissipative_scheme_gains_no_energy)
{
  for (const Impact &impact : family())
    check(impact, "dissipative", true);
}



TEST(BlockImpact, constant_acceleration_scheme_of_shi_gains_no_energy)
{
  for (const Impact &impact : family())
    check(impact, "shi", true);
}



// Without damping of high frequencies a contact that opens within a step gives back more than it
// stored (up to 40 % of a slow impact at 1 ms); the audit shows it as a negative integration loss.
TEST(BlockImpact, trapezoidal_scheme_accounts_for_its_energy)
{
  for (const Impact &impact : family())
    check(impact, "trapezoidal", false);
}
