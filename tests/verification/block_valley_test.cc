// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that slide into the foot of a wall, with a corner or a needle's tip
// first: whatever their shape, tilt, speed, friction, stiffness and scheme,
// they stay above the ground and gain no energy.
#include "block_scenes.h"

#include <hybrid/dda/step/block_energy.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  constexpr int    n_scenes = 300;
  constexpr double gap      = 0.05; ///< between corner and foot at the start [m]

  struct Outcome
  {
    bool   begins    = true; ///< outside of the ground
    bool   converges = true;
    double gain      = 0.; ///< largest energy above that at the start, over it [-]
    double depth     = 0.; ///< of a corner in the ground, largest [m]
    double advance   = 0.; ///< way in one step [m]
    int    cuts      = 0;  ///< of steps
  };

  /// Uniform between two numbers, the same on all machines.
  class Random
  {
  public:
    explicit Random(const unsigned seed)
      : generator(seed)
    {}

    double operator()(const double low, const double high)
    {
      return low + (high - low) * (generator() / 4294967296.);
    }

    int below(const int n)
    {
      return static_cast<int>(generator() % n);
    }

  private:
    std::mt19937 generator;
  };

  /// A needle, a triangle or a rectangle left of the foot at the origin, its
  /// lower right corner first and 0.1 mm above the floor, turned about it.
  std::vector<Vec2> outline(Random &random)
  {
    const double length = random(0.5, 2.), height = random(0.2, 1.5);
    const double rise = length * std::tan(random(0.5, random.below(2) ? 5. : 60.) * M_PI / 180.);
    std::vector<Vec2> shape;
    switch (random.below(3))
      {
        case 0: // tip first
          shape = {{0., 0.}, {-length, rise}, {-length, 0.}};
          break;
        case 1: // face first
          shape = {{0., 0.}, {0., rise}, {-length, 0.}};
          break;
        default:
          shape = {{0., 0.}, {0., height}, {-length, height}, {-length, 0.}};
      }
    const double tilt = random.below(2) * random(0., 0.2), c = std::cos(tilt), s = std::sin(tilt);
    for (Vec2 &x : shape)
      x = Vec2(c * x.x() + s * x.y() - gap, -s * x.x() + c * x.y() + 1e-4);
    return shape;
  }

  Outcome slide(const unsigned seed)
  {
    Random                 random(seed);
    scene::SceneParameters p =
      block_parameters(10. * random.below(4), std::exp(random(std::log(1e8), std::log(5e10))));
    p.time.newmark =
      Newmark::preset(std::array{"dissipative", "shi", "trapezoidal"}[random.below(3)]);
    const double wall = random(15., 88.) * M_PI / 180., speed = random(0.5, 6.);
    const double side = random.below(2) ? 1. : -1.; // mirrored

    scene::SectionMesh mesh;
    mesh.block_region_names = {"sliding_mass"};
    std::vector<Vec2> shape = outline(random);
    if (side < 0.)
      std::reverse(shape.begin(), shape.end());
    mesh.blocks.emplace_back();
    for (const Vec2 &x : shape)
      {
        mesh.blocks[0].push_back(static_cast<int>(mesh.nodes.size()));
        mesh.nodes.push_back({side * x.x(), x.y()});
      }
    mesh.block_region.push_back(0);
    const Vec2        up(side * std::cos(wall), std::sin(wall));
    std::vector<Vec2> ground{{-side * 20., 0.}, {0., 0.}, 20. * up};
    if (side < 0.)
      std::reverse(ground.begin(), ground.end());

    FixedBaseRun run(mesh, p, ground);
    run.state.blocks[0].velocity[0] = side * speed;
    run.state.energy                = dda::stored_energy(run.model, run.state);
    const double start              = run.state.energy.kinetic;
    const Vec2   normal(-side * up.y(), side * up.x()); // out of the wall
    Outcome      outcome;
    const auto   depth = [&] {
      double deepest = 0.;
      for (const Vec2 &x : run.state.geometry.vertices)
        deepest = std::max({deepest, -x.y(), -normal.dot(x)});
      return deepest;
    };
    outcome.begins = depth() == 0.;
    if (!outcome.begins)
      return outcome;
    const double dt = random(2e-4, 1e-3);
    outcome.advance = dt * speed;
    while (outcome.converges && run.state.time < 0.5 / speed)
      {
        outcome.converges         = run.advance(dt, 20);
        const dda::BlockEnergy &e = run.state.energy;
        // Weight moves the mass: what it has fallen is not gained.
        outcome.gain =
          std::max(outcome.gain, (e.kinetic + e.strain + e.springs + e.gravity) / start - 1.);
        outcome.depth = std::max(outcome.depth, depth());
      }
    outcome.cuts = run.cuts;
    return outcome;
  }
} // namespace

TEST(BlockValley, holds_what_slides_into_it)
{
  int slides = 0;
  for (unsigned seed = 0; seed < n_scenes; ++seed)
    {
      const Outcome outcome = slide(seed);
      slides += outcome.begins;
      EXPECT_TRUE(outcome.converges) << "seed " << seed;
      EXPECT_LE(outcome.gain, 1e-3) << "seed " << seed;
      EXPECT_LE(outcome.cuts, 500) << "seed " << seed; // in vain: tens of thousands
      EXPECT_LE(outcome.depth, 2. * outcome.advance + 1e-3) << "seed " << seed;
    }
  EXPECT_GT(slides, n_scenes / 2);
}
