// SPDX-License-Identifier: GPL-3.0-or-later
// A mass under its weight on rock with viscous boundaries: what has settled stays where it is, the
// rock carries exactly its weight, and a pulse through it keeps the energy balance.
#include "coupled_scenes.h"

#include <hybrid/dda/statics/static_stage.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  /// A mass of 5 x 4 m in 40 triangles on 15 x 4 m of rock.
  Section mass_on_rock()
  {
    Section layout;
    layout.columns      = 15;
    layout.rows         = 4;
    layout.first        = 5;
    layout.mass_columns = 5;
    layout.mass_rows    = 4;
    return layout;
  }



  scene::SceneParameters resting_parameters()
  {
    scene::SceneParameters scene          = coupled_parameters();
    Material              &mass           = scene.materials["mass"];
    mass.young_modulus                    = 50e6;
    mass.friction_angle                   = 30.;
    mass.cohesion                         = 80e3;
    mass.tensile_strength                 = 60e3;
    scene.materials["rock"].young_modulus = 5e9;
    return scene;
  }



  dda::StaticResult settle(CoupledRun &run)
  {
    const dda::StaticResult result = dda::settle(run.model, run.state.blocks, false);
    run.rock.solve_static_state(run.state.blocks.static_force, run.model.gravity);
    return result;
  }



  double weight(const CoupledRun &run)
  {
    double sum = 0.;
    for (const dda::BlockProperties &block : run.model.blocks)
      sum += block.weight * run.model.gravity;
    return sum;
  }



  /// Sum of the blocks' forces on the rock [N/m].
  Vec2 foundation_force(const CoupledRun &run)
  {
    Vec2 sum = Vec2::Zero();
    for (Eigen::Index k = 0; k < run.state.blocks.foundation_force.size(); k += 2)
      sum += run.state.blocks.foundation_force.segment<2>(k);
    return sum;
  }



  int failed_joints(const CoupledRun &run)
  {
    int n = 0;
    for (const dda::JointState &joint : run.state.blocks.joints)
      n += joint.failure != dda::FailureKind::none ? 1 : 0;
    return n;
  }



  /// Ten seconds in which nothing may happen. @return largest motion of a vertex or surface node
  /// [m].
  double creep(CoupledRun &run, const double dt)
  {
    const std::vector<Vec2> start = run.state.blocks.geometry.vertices;
    double                  worst = 0.;
    while (run.state.time < 10. - 0.5 * dt)
      if (!run.advance(dt, 4))
        return 1e300;
    for (std::size_t v = 0; v < start.size(); ++v)
      worst = std::max(worst, (run.state.blocks.geometry.vertices[v] - start[v]).norm());
    return std::max(worst, run.state.blocks.foundation_displacement.lpNorm<Eigen::Infinity>());
  }



  void expect_rest(CoupledRun &run)
  {
    const dda::StaticResult settled = settle(run);
    ASSERT_TRUE(settled.equilibrium);
    const double w      = weight(run);
    const int    failed = failed_joints(run);
    EXPECT_NEAR(foundation_force(run).x(), 0., 1e-8 * w);
    EXPECT_NEAR(foundation_force(run).y(), -w, 1e-8 * w);
    const double moved = creep(run, 5e-3);
    std::printf(
      "settled to %.1e, %d of %zu joints failed, weight error %.1e, largest motion in 10 s %.1e m, %d cuts\n",
      settled.residual,
      failed,
      run.model.joints.size(),
      std::abs(foundation_force(run).y() / w + 1.),
      moved,
      run.cuts);
    EXPECT_LT(moved, 1e-6);
    EXPECT_EQ(failed_joints(run), failed);
  }
} // namespace



TEST(CouplingRest, bonded_mass_stays)
{
  CoupledRun run(mass_on_rock(), resting_parameters());
  expect_rest(run);
}



// A weak mass: joints crack and slide to their limit while it settles; what is left stands.
TEST(CouplingRest, partly_failed_mass_stays)
{
  scene::SceneParameters scene              = resting_parameters();
  scene.materials["mass"].tensile_strength  = 1e3;
  scene.materials["mass"].cohesion          = 11e3;
  scene.materials["mass"].friction_angle    = 25.;
  scene.materials["mass"].residual_cohesion = 10e3;
  scene.blocks.softening_slip               = 3e-3;
  CoupledRun run(mass_on_rock(), scene);
  expect_rest(run);
  EXPECT_GT(failed_joints(run), 0);
}



// Unbonded blocks that rest by contact alone.
TEST(CouplingRest, loose_blocks_stay)
{
  scene::SceneParameters scene           = resting_parameters();
  scene.blocks.bonded                    = false;
  scene.materials["mass"].friction_angle = 50.;
  scene.blocks.belt_material.clear();
  CoupledRun run(mass_on_rock(), scene);
  expect_rest(run);
}



TEST(CouplingRest, pulse_and_gravity_keep_the_energy_balance)
{
  const double        dt = 1e-3, f = 5.;
  std::vector<double> a;
  for (double t = 0.; t <= 3. / f; t += dt)
    {
      const double s = std::pow(M_PI * f * (t - 1.5 / f), 2);
      a.push_back(0.5 * (1. - 2. * s) * std::exp(-s));
    }
  CoupledRun run(mass_on_rock(), resting_parameters(), scene::Motion(dt, a));
  ASSERT_TRUE(settle(run).equilibrium);
  run.audit();
  while (run.state.time < 1.)
    {
      ASSERT_TRUE(run.advance(dt, 4));
      run.audit();
    }
  std::printf("energy residual %.1e, %d steps, %d cuts, %d joints failed\n",
              run.audit(),
              run.steps,
              run.cuts,
              failed_joints(run));
  EXPECT_LT(run.audit(), 1e-3);
}
