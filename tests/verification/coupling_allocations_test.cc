// SPDX-License-Identifier: GPL-3.0-or-later
// How often a steady step of blocks and bedrock asks for memory: see block_allocations_test.cc.
#include "coupled_scenes.h"
#include "memory_requests.h"

#include <hybrid/dda/statics/static_stage.h>

#include <gtest/gtest.h>

#include <cstdio>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  constexpr double dt     = 1e-3; ///< [s]
  constexpr int    warmup = 30, steps = 20;

  /// Most in a step of a bonded mass that a pulse shakes from below.
  long most_requests(const scene::SurfaceForm form)
  {
    Section layout;
    layout.columns      = 15;
    layout.rows         = 4;
    layout.first        = 5;
    layout.mass_columns = 5;
    layout.mass_rows    = 4;

    scene::SceneParameters parameters          = coupled_parameters();
    parameters.continuum.surface_form          = form;
    Material &mass                             = parameters.materials["mass"];
    mass.young_modulus                         = 50e6;
    mass.friction_angle                        = 30.;
    mass.cohesion                              = 80e3;
    mass.tensile_strength                      = 60e3;
    parameters.materials["rock"].young_modulus = 5e9;

    std::vector<double> pulse(200);
    for (std::size_t k = 0; k < pulse.size(); ++k)
      pulse[k] = std::sin(2. * M_PI * 10. * static_cast<double>(k) * dt);
    CoupledRun run(layout, parameters, scene::Motion(dt, pulse));
    EXPECT_TRUE(dda::settle(run.model, run.state.blocks, false).equilibrium);
    run.rock.solve_static_state(run.state.blocks.static_force, run.model.gravity);
    for (int k = 0; k < warmup; ++k)
      EXPECT_TRUE(run.advance(dt));
    long most = 0;
    for (int k = 0; k < steps; ++k)
      {
        const long before = memory_requests;
        EXPECT_TRUE(run.advance(dt));
        most = std::max(most, memory_requests - before);
      }
    std::printf("  at most %ld requests of memory in one of %d steps; %.1f iterations per step\n",
                most,
                steps,
                static_cast<double>(run.iterations) / run.steps);
    return most;
  }
} // namespace


TEST(Allocations, OfBlocksOnBedrock)
{
  EXPECT_LE(most_requests(scene::SurfaceForm::dense), 0);
}


TEST(Allocations, OfBlocksOnALongSurface)
{
  EXPECT_LE(most_requests(scene::SurfaceForm::banded), 0);
}
