// SPDX-License-Identifier: GPL-3.0-or-later
// Two sharp tips that meet corner on corner, so that no corner comes in through an edge: whatever
// their angles, speeds, stiffness and scheme, no energy is created and they do not pass through
// each other.
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

  constexpr int    n_meetings = 1500;
  constexpr double first_gap  = 1e-3; ///< between the tips [m]

  struct Tip
  {
    Vec2   place;     ///< [m]
    double direction; ///< in which it points, from the x axis [rad]
    double angle;     ///< between its sides [rad]
    double length;    ///< of its sides [m]
  };

  /// Uniform between two numbers, or between their logarithms. The same numbers on all machines.
  class Random
  {
  public:
    explicit Random(const unsigned seed)
      : generator(seed)
    {}

    double uniform(const double low, const double high)
    {
      return low + (high - low) * (generator() / 4294967296.);
    }

    double logarithmic(const double low, const double high)
    {
      return std::exp(uniform(std::log(low), std::log(high)));
    }

    int below(const int n)
    {
      return static_cast<int>(generator() % n);
    }

  private:
    std::mt19937 generator;
  };



  Vec2 unit(const double angle)
  {
    return Vec2(std::cos(angle), std::sin(angle));
  }



  void add(const Tip &tip, scene::SectionMesh &mesh)
  {
    const int n = static_cast<int>(mesh.nodes.size());
    mesh.nodes.push_back(tip.place);
    mesh.nodes.push_back(tip.place - tip.length * unit(tip.direction - 0.5 * tip.angle));
    mesh.nodes.push_back(tip.place - tip.length * unit(tip.direction + 0.5 * tip.angle));
    mesh.blocks.push_back({n, n + 1, n + 2});
    mesh.block_region.push_back(0);
  }



  /// How far two triangles have gone into each other: the shortest way out along a normal of their
  /// sides [m], negative apart.
  double depth(const dda::Geometry &g)
  {
    double least = 1e300;
    for (const int body : {0, 1})
      for (int e = g.offset[body]; e < g.offset[body + 1]; ++e)
        {
          const Vec2 along   = (g.vertices[g.next(e)] - g.vertices[e]).normalized();
          double     deepest = -1e300;
          for (int v = g.offset[1 - body]; v < g.offset[2 - body]; ++v)
            deepest = std::max(deepest, cross(along, g.vertices[v] - g.vertices[e]));
          least = std::min(least, deepest);
        }
    return least;
  }



  struct Outcome
  {
    bool   meets     = false; ///< apart at first
    bool   converges = true;
    double gain      = 0.; ///< largest energy above that at the start, over it [-]
    double depth     = 0.; ///< largest [m]
    double way       = 0.; ///< of the tips towards each other in one step [m]
  };



  Outcome meet(const unsigned seed)
  {
    Random random(seed);

    const double           friction_angle = 15. * random.below(3);
    scene::SceneParameters p = block_parameters(friction_angle, random.logarithmic(5e7, 5e10));
    const char *const preset = std::array{"dissipative", "shi", "trapezoidal"}[random.below(3)];
    p.time.newmark           = Newmark::preset(preset);
    p.time.maximum_displacement_ratio = 0.05;
    p.environment.gravity             = 0.;

    const auto tip = [&](const Vec2 &place) {
      const double direction = random.uniform(-M_PI, M_PI);
      const double angle     = random.logarithmic(2., 80.) * M_PI / 180.;
      return Tip{place, direction, angle, random.uniform(0.5, 2.)};
    };
    const double speed    = random.logarithmic(0.1, 20.);
    const Vec2   towards  = unit(random.uniform(-M_PI, M_PI));
    const double offset   = std::array{0., 1e-9, 1e-6, 1e-4, 1e-3}[random.below(5)];
    const Vec2   sideways = (random.below(2) ? offset : -offset) * Vec2(-towards.y(), towards.x());

    scene::SectionMesh mesh;
    mesh.block_region_names = {"sliding_mass"};
    const Vec2 origin(0., 10.);
    add(tip(origin), mesh);
    add(tip(origin + first_gap * towards + sideways), mesh);

    FixedBaseRun run(mesh, p, straight_foundation(0., 100., 100.));
    Outcome      outcome;
    outcome.meets = depth(run.state.geometry) < -1e-7;
    if (!outcome.meets)
      return outcome;
    for (const int body : {0, 1})
      {
        dda::Vec6 &velocity = run.state.blocks[body].velocity;
        velocity.head<2>()  = (body == 0 ? 0.5 : -0.5) * speed * towards;
        velocity[2]         = random.below(2) * random.uniform(-1., 1.) * speed;
      }
    run.state.energy   = dda::stored_energy(run.model, run.state);
    const double start = run.state.energy.kinetic;
    outcome.way        = std::min(1e-3 * speed, random.uniform(1e-3, 1e-2));
    while (outcome.converges && run.state.time < 0.1 / speed)
      {
        outcome.converges         = run.advance(outcome.way / speed, 10);
        const dda::BlockEnergy &e = run.state.energy;
        outcome.gain  = std::max(outcome.gain, (e.kinetic + e.strain + e.springs) / start - 1.);
        outcome.depth = std::max(outcome.depth, depth(run.state.geometry));
      }
    return outcome;
  }
} // namespace



TEST(BlockTips, create_no_energy_and_do_not_pass_through_each_other)
{
  int meetings = 0;
  for (unsigned seed = 0; seed < n_meetings; ++seed)
    {
      const Outcome outcome = meet(seed);
      if (!outcome.meets)
        continue;
      ++meetings;
      EXPECT_TRUE(outcome.converges) << "seed " << seed;
      EXPECT_LE(outcome.gain, 1e-3) << "seed " << seed;
      EXPECT_LE(outcome.depth, 2. * outcome.way) << "seed " << seed;
    }
  EXPECT_GT(meetings, n_meetings / 2);
}
