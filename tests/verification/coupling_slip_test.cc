// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks on bedrock with a bedding plane that slips close below them: with the surface motion and
// the interface forces of every accepted step the tractions of the plane are within its strength
// (so blocks, rock and plane agree at the same time), no step is cut, and energy closes.
#include "coupled_scenes.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <tuple>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  constexpr double friction = 30., cohesion = 500., compression = 4e3;

  scene::Motion shaking(const double peak)
  {
    std::vector<double> a;
    for (int i = 0; i < 300; ++i)
      a.push_back(peak * std::sin(2. * M_PI * 10. * i * 1e-3));
    return {1e-3, a};
  }


  struct Outcome
  {
    double excess   = 0.; ///< traction beyond the strength over the largest traction [-]
    double residual = 0., loss = 0., rounds = 0.;
    int    cuts = 0;
  };


  /// @param ratio modulus of the blocks over that of the rock.
  Outcome run(const double ratio, const int rows_of_blocks, const double joint_stiffness)
  {
    scene::SceneParameters scene = coupled_parameters();
    scene.environment.gravity    = 0.;
    scene.materials["mass"].young_modulus *= ratio;
    scene.bedding.names                 = {"bedding_1"};
    scene.bedding.normal_stiffness      = joint_stiffness;
    scene.bedding.shear_stiffness       = joint_stiffness;
    scene.bedding.slips                 = true;
    scene.bedding.friction_angle        = friction;
    scene.bedding.cohesion              = cohesion;
    scene.bedding.initial_normal_stress = compression;
    Section layout;
    layout.columns = layout.mass_columns = 6;
    layout.rows                          = 4;
    layout.mass_rows                     = rows_of_blocks;
    layout.plane_row                     = 3;
    CoupledRun run(layout, scene, shaking(4.));

    Outcome outcome;
    for (int k = 0; k < 200; ++k)
      {
        if (!run.advance(1e-3, 4))
          return outcome.cuts = 1000, outcome;
        outcome.residual = run.audit();
        const auto v = run.rock.bedding_values(run.state.continuum, run.rock.slipping_planes()[0]);
        for (std::size_t i = 0; i < v.slip.size(); ++i)
          {
            const bool   broken = run.state.continuum.slip.failed[i];
            const double limit =
              (broken ? 0. : cohesion) + std::tan(friction * M_PI / 180.) * v.normal_stress[i];
            outcome.excess = std::max(outcome.excess, std::abs(v.shear_stress[i]) - limit);
            outcome.excess = std::max(outcome.excess, -v.normal_stress[i]);
          }
      }
    outcome.excess /= compression;
    outcome.loss   = run.state.continuum.energy.bedding_loss;
    outcome.cuts   = run.cuts;
    outcome.rounds = static_cast<double>(run.step->timings().slip_rounds) / run.steps;
    std::printf("blocks/rock %6g, rows %d, joint %g: excess %.1e, residual %.1e, loss %.3g J/m, "
                "further solutions per step %.2f, cuts %d\n",
                ratio,
                rows_of_blocks,
                joint_stiffness,
                outcome.excess,
                outcome.residual,
                outcome.loss,
                outcome.rounds,
                outcome.cuts);
    return outcome;
  }
} // namespace


TEST(CoupledSlip, blocks_rock_and_plane_agree)
{
  for (const auto &[ratio, rows, joint] : {std::tuple(0.1, 1, 1e9),
                                           std::tuple(1., 4, 1e9),
                                           std::tuple(100., 1, 1e9),
                                           std::tuple(100., 4, 1e10)})
    {
      const Outcome outcome = run(ratio, rows, joint);
      EXPECT_LT(outcome.excess, 1e-6);
      EXPECT_LT(outcome.residual, 1e-6);
      EXPECT_GT(outcome.loss, 0.);
      EXPECT_EQ(outcome.cuts, 0);
    }
}
