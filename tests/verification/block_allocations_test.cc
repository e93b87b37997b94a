// SPDX-License-Identifier: GPL-3.0-or-later
// How often a steady step of blocks asks for memory. The goal is never; what is asserted is that it
// does not become more often. All requests of this process are counted, those of Eigen and CHOLMOD
// too (memory_requests.h).
#include "block_scenes.h"
#include "memory_requests.h"

#include <hybrid/dda/statics/static_stage.h>

#include <gtest/gtest.h>

#include <cstdio>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  constexpr double dt     = 1e-3; ///< [s]
  constexpr int    warmup = 30;   ///< steps, in which lists grow to the size that they need
  constexpr int    steps  = 20;

  /// What the steps after the first have asked for.
  struct Requests
  {
    long most  = 0; ///< of a step
    long total = 0;
    int  cuts  = 0;
  };

  Requests count(FixedBaseRun &run)
  {
    Requests found;
    EXPECT_TRUE(run.run(run.state.time + warmup * dt, dt));
    const int cuts = run.cuts;
    for (int k = 0; k < steps; ++k)
      {
        const long before = memory_requests;
        EXPECT_TRUE(run.advance(dt, 0));
        const long asked = memory_requests - before;
        found.most       = std::max(found.most, asked);
        found.total += asked;
      }
    found.cuts = run.cuts - cuts;
    return found;
  }

  void report(const Requests &found, const FixedBaseRun &run)
  {
    std::printf("  %ld requests of memory in %d steps, at most %ld in one; %d blocks, %.1f "
                "iterations per step\n",
                found.total,
                steps,
                found.most,
                run.model.n_blocks(),
                static_cast<double>(run.iterations) / run.steps);
  }
} // namespace


// The counters count: a vector, one of Eigen's, one of the C library.
TEST(Allocations, AreCounted)
{
  long       before = memory_requests;
  const auto three  = std::make_unique<std::vector<double>>(100);
  EXPECT_GE(memory_requests - before, 2);
  before = memory_requests;
  Eigen::VectorXd vector(100);
  vector.setZero();
  EXPECT_EQ(memory_requests - before, 1);
  before       = memory_requests;
  void *memory = std::calloc(3, 8);
  EXPECT_EQ(memory_requests - before, 1);
  std::free(memory);
}


// A wall that stands.
TEST(Allocations, OfBlocksAtRest)
{
  FixedBaseRun run(square_blocks(10, 4),
                   block_parameters(25., 5e9),
                   straight_foundation(0., 5., 15.));
  ASSERT_TRUE(dda::settle(run.model, run.state).equilibrium);
  const Requests found = count(run);
  report(found, run);
  EXPECT_EQ(found.cuts, 0);
  EXPECT_LE(found.most, 0);
}


// A row that slides.
TEST(Allocations, OfBlocksThatSlide)
{
  const double slope = 20. * M_PI / 180.;
  FixedBaseRun run(square_blocks(20, 1, 1., slope),
                   block_parameters(15., 5e9),
                   straight_foundation(slope, 20., 40.));
  ASSERT_TRUE(dda::settle(run.model, run.state, true).equilibrium);
  const Requests found = count(run);
  report(found, run);
  EXPECT_EQ(found.cuts, 0);
  EXPECT_LE(found.most, 0);
}


// Stiff columns that lean on each other and slide: the interior point method in nearly each step.
TEST(Allocations, OfBlocksOnTheCentralPath)
{
  const double   slope = 20. * M_PI / 180.;
  FixedBaseRun   run(square_blocks(10, 5, 1., slope),
                   block_parameters(15., 50e9),
                   straight_foundation(slope, 20., 40.));
  const Requests found = count(run);
  report(found, run);
  EXPECT_EQ(found.cuts, 0);
  EXPECT_GT(run.iterations, 5 * run.steps);
  EXPECT_LE(found.most, 0);
}


// A bonded mass that vibrates and does not break.
TEST(Allocations, OfBondedBlocks)
{
  scene::SceneParameters p             = block_parameters(45., 160e6, 2000.);
  p.materials["rock"].cohesion         = 1e9;
  p.materials["rock"].tensile_strength = 1e9;
  p.blocks.bonded                      = true;
  p.environment.gravity                = 0.;
  FixedBaseRun run(square_blocks(20, 20), p, straight_foundation(0., 5., 25.));
  for (std::size_t b = 0; b < run.state.blocks.size(); ++b)
    run.state.blocks[b].velocity[0] = 1e-3 * std::sin(0.3 * run.state.blocks[b].centroid.y());
  const Requests found = count(run);
  report(found, run);
  EXPECT_EQ(found.cuts, 0);
  EXPECT_LE(found.most, 0);
}
