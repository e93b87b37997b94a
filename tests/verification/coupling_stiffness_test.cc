// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness ratios of bedrock to blocks from 1e-3 to 1e6: the pulse goes through, every step
// converges, and no energy is created. Closed form for the first arrival behind the interface: the
// transmitted velocity is 2 Z_rock / (Z_rock + Z_blocks) of the incident one.
#include "coupled_scenes.h"

#include <hybrid/scene/boundary/fixed_side.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  /// Outcrop motion of a raised cosine of velocity, upgoing peak 1 m/s.
  scene::Motion raised_cosine(const double duration, const double sampling)
  {
    std::vector<double> a;
    for (double t = 0.; t <= duration * (1. + 1e-9); t += sampling)
      a.push_back(2. * M_PI / duration * std::sin(2. * M_PI * t / duration));
    return {sampling, a};
  }



  void expect_stable(const double ratio)
  {
    scene::SceneParameters scene = coupled_parameters();
    scene.environment.gravity    = 0.;
    scene.continuum.sides        = scene::fixed_side(); // of the separate cell only
    scene.materials["rock"].young_modulus *= ratio;
    const Material &rock = scene.materials.at("rock"), &mass = scene.materials.at("mass");

    // The pulse is resolved on the softer side.
    Section layout;
    layout.rows           = 8;
    layout.mass_rows      = 16;
    layout.walled         = true;
    const double slower   = std::min(rock.s_wave_speed(), mass.s_wave_speed());
    const double duration = 30. * layout.size / slower, dt = duration / 200.;
    const double incident = 1e-3; // m/s
    CoupledRun   run(layout, scene, raised_cosine(duration, dt).scaled(incident), Wave::shear);

    const int    block  = run.block_at(Vec2(1., 0.5));
    const double height = layout.size * layout.mass_rows, depth = layout.size * layout.rows;
    // Through the column and five times up and down in the blocks.
    const double end = duration + depth / rock.s_wave_speed() + 10. * height / mass.s_wave_speed();
    double       highest = 0., received = 0., residual = 0., first = 0.;
    const double arrival = depth / rock.s_wave_speed(),
                 echo    = arrival + 2. * height / mass.s_wave_speed();
    const int steps      = std::min(4000, static_cast<int>(end / dt));
    for (int k = 0; k < steps; ++k)
      {
        ASSERT_TRUE(run.advance(dt)) << "step " << k;
        residual          = run.audit();
        const auto  &c    = run.state.continuum.energy;
        const auto  &b    = run.state.blocks.energy;
        const double held = c.kinetic + c.strain + b.kinetic + b.strain + b.springs;
        received          = std::max(received, c.input_work);
        highest           = std::max(highest, held);
        ASSERT_TRUE(std::isfinite(held));
        if (run.state.time < echo)
          first = std::max(first, std::abs(run.state.blocks.blocks[block].velocity[0]));
      }
    const double z_rock      = rock.density * rock.s_wave_speed(),
                 z_mass      = mass.density * mass.s_wave_speed();
    const double transmitted = incident * 2. * z_rock / (z_rock + z_mass);
    std::printf(
      "ratio %7g: %d steps, iterations per step %.2f, residual %.1e, held/received %.3f, first arrival/closed form %.3f\n",
      ratio,
      run.steps,
      static_cast<double>(run.iterations) / run.steps,
      residual,
      highest / received,
      first / transmitted);
    EXPECT_EQ(run.cuts, 0);
    EXPECT_LT(residual, 1e-3);
    EXPECT_LE(highest, 1.01 * received);
    EXPECT_GT(highest, 0.);
    // Behind softer rock the pulse is longer than the way to the surface and back.
    if (ratio >= 1.)
      {
        EXPECT_NEAR(first, transmitted, 0.01 * transmitted);
      }
  }
} // namespace



TEST(CouplingStiffness, rock_a_thousand_times_softer)
{
  expect_stable(1e-3);
}



TEST(CouplingStiffness, rock_a_little_softer)
{
  expect_stable(0.1);
}



TEST(CouplingStiffness, equal)
{
  expect_stable(1.);
}



TEST(CouplingStiffness, rock_a_thousand_times_harder)
{
  expect_stable(1e3);
}



TEST(CouplingStiffness, rock_a_million_times_harder)
{
  expect_stable(1e6);
}
