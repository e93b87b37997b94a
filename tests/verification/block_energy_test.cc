// SPDX-License-Identifier: GPL-3.0-or-later
// The energy audit closes: 0.1 % of the exchanged energy in smooth scenes, 1 % with contact and
// fracture.
#include "block_scenes.h"

#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/dda/step/block_energy.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  struct Audit
  {
    double residual  = 0.; ///< largest |balance - start| [J/m]
    double exchanged = 0.; ///< sum of absolute changes of the held energies [J/m]
  };



  Audit run_with_audit(FixedBaseRun &run, const double end_time, const double dt)
  {
    Audit            audit;
    dda::BlockEnergy old   = run.state.energy;
    const double     start = old.balance();
    while (run.state.time < end_time - 1e-9)
      {
        EXPECT_TRUE(run.advance(dt, 10)) << run.state.time;
        const dda::BlockEnergy &e = run.state.energy;
        audit.exchanged += std::abs(e.kinetic - old.kinetic) + std::abs(e.strain - old.strain) +
                           std::abs(e.gravity - old.gravity) + std::abs(e.springs - old.springs);
        audit.residual = std::max(audit.residual, std::abs(e.balance() - start));
        old            = e;
      }
    return audit;
  }



  /// A cantilever of 8 x 1 squares, bonded to the base below its first two.
  FixedBaseRun cantilever(const double tensile_strength, const char *preset)
  {
    scene::SceneParameters p             = block_parameters(30.);
    p.blocks.bonded                      = true;
    p.blocks.belt_material               = "belt";
    p.time.newmark                       = Newmark::preset(preset);
    p.materials["rock"].tensile_strength = tensile_strength;
    p.materials["rock"].cohesion         = 2. * tensile_strength;
    p.materials["belt"]                  = p.materials["rock"];
    p.materials["belt"].name             = "belt";
    p.materials["belt"].tensile_strength = p.materials["belt"].cohesion = 1e8;
    scene::SectionMesh mesh                                             = square_blocks(8, 1);
    mesh.lines["sliding_surface"]                                       = {{0, 1}, {1, 2}};
    return FixedBaseRun(mesh, p, {{0., 0.}, {1., 0.}, {2., 0.}, {2.5, -1.5}, {12., -1.5}});
  }
} // namespace



TEST(BlockEnergyAudit, cantilever_released_under_its_weight_vibrates)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      FixedBaseRun run   = cantilever(1e9, preset);
      const Audit  audit = run_with_audit(run, 1., 1e-3);
      EXPECT_LT(audit.residual, 1e-3 * audit.exchanged) << preset;
      EXPECT_GT(audit.exchanged, 1e3);
    }
}



TEST(BlockEnergyAudit, cantilever_yields_under_its_weight)
{
  for (const char *preset : {"dissipative", "trapezoidal", "shi"})
    for (const double damping_time : {0., 2e-3})
      {
        FixedBaseRun run       = cantilever(1e9, preset);
        run.model.blocks_yield = true;
        for (dda::BlockProperties &block : run.model.blocks)
          {
            block.strength     = {5e4, std::sin(0.4), std::cos(0.4), std::sin(0.1)};
            block.damping_time = damping_time;
          }
        const Audit audit  = run_with_audit(run, 0.6, 1e-3);
        double      strain = 0.;
        for (const dda::BlockState &block : run.state.blocks)
          strain = std::max(strain, block.plastic_strain);
        EXPECT_GT(strain, 1e-4) << preset;
        EXPECT_GT(run.state.energy.yield_loss, 0.01 * audit.exchanged) << preset;
        EXPECT_GE(run.state.energy.integration_loss, -1e-6 * audit.exchanged) << preset;
        EXPECT_LT(audit.residual, 1e-3 * audit.exchanged) << preset;
      }
}



TEST(BlockEnergyAudit, block_slides_down_an_incline)
{
  const double slope = 30. * M_PI / 180.;
  FixedBaseRun run(square_blocks(1, 1, 1., slope),
                   block_parameters(15.),
                   straight_foundation(slope, 20., 5., 40));
  ASSERT_TRUE(dda::settle(run.model, run.state, true).equilibrium);
  const Audit audit = run_with_audit(run, 1., 1e-3);
  EXPECT_LT(audit.residual, 1e-3 * audit.exchanged);
}



TEST(BlockEnergyAudit, cantilever_breaks_under_its_weight_and_falls_on_the_base)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      FixedBaseRun run    = cantilever(1e5, preset);
      const Audit  audit  = run_with_audit(run, 1.2, 1e-3);
      int          failed = 0;
      for (const dda::JointState &joint : run.state.joints)
        failed += joint.failure != dda::FailureKind::none ? 1 : 0;
      EXPECT_GE(failed, 1) << preset;
      EXPECT_GT(run.state.energy.fracture_loss + run.state.energy.friction_loss, 0.) << preset;
      EXPECT_LT(run.state.energy.gravity, -2e4) << preset; // it has fallen
      EXPECT_LT(audit.residual, 1e-2 * audit.exchanged) << preset;
    }
}
