// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/moving_blocks.h>
#include <hybrid/dda/springs/spring_work.h>
#include <hybrid/dda/step/block_energy.h>
#include <hybrid/dda/step/initial_state.h>

#include <gtest/gtest.h>

#include "block_scenes.h"

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  /// Two bonded squares of 1 m that spin about the middle of their joint.
  scene::SceneParameters spinning_pair(const char *preset)
  {
    scene::SceneParameters p             = test::block_parameters(30., 5e9);
    p.environment.gravity                = 0.;
    p.blocks.bonded                      = true;
    p.materials["rock"].tensile_strength = 1e9;
    p.materials["rock"].cohesion         = 1e9;
    p.time.newmark                       = Newmark::preset(preset);
    p.blocks.initial_velocities          = {{"pair", Vec2(0., 0.), Vec2(2., 1.), Vec2::Zero(), 6.}};
    return p;
  }
} // namespace



// A pair turned as a rigid body by w dt: the joint's force F goes from square to the chord, at the
// start -w dt / 2 off, to w dt / 2 off; on two centres that each move by r w dt.
TEST(SpringWork, of_a_turning_force_is_that_on_the_chord)
{
  test::FixedBaseRun run(test::square_blocks(2, 1), spinning_pair("dissipative"), {});
  set_in_motion(run.model, run.state);
  ASSERT_TRUE(run.run(0.5, 1e-4)); // until it no longer rings
  const DdaState before = run.state;
  const double   dt     = 1e-4;
  const double   spin   = before.blocks[0].velocity[2];
  const double   force  = 2220. * 0.5 * spin * spin;

  // The step by its kinematics: springs keep what they carry.
  Trial trial;
  trial.dt         = dt;
  trial.foundation = before.foundation_displacement;
  const Vec2 axis  = 0.5 * (before.blocks[0].centroid + before.blocks[1].centroid);
  trial.displacement.resize(before.geometry.vertices.size());
  for (int b = 0; b < 2; ++b)
    {
      const Vec2   arm = before.blocks[b].centroid - axis;
      const double c = std::cos(spin * dt), s = std::sin(spin * dt);
      Vec6         d = Vec6::Zero();
      d.head<2>()    = Vec2(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y()) - arm;
      d[2]           = spin * dt;
      trial.increment.push_back(d);
      trial.motion.emplace_back(before.blocks[b].centroid, d);
      for (int v = before.geometry.offset[b]; v < before.geometry.offset[b + 1]; ++v)
        trial.displacement[v] = trial.motion[b].displacement(before.geometry.vertices[v]);
    }
  Springs springs;
  springs.collect(run.model, before);
  springs.evaluate(run.model, before, trial);
  double work = 0.;
  for (std::size_t i = 0; i < springs.springs.size(); ++i)
    {
      const SpringState &old = springs.springs[i].old, &now = springs.responses[i].now;
      work += turning_work({run.model, before, trial, springs},
                           i,
                           {old.normal, old.shear},
                           {now.normal, now.shear})
                .rotation;
    }
  const double expected = -2. * force * 0.5 * std::pow(spin * dt, 2);
  EXPECT_NEAR(work, expected, 1e-3 * std::abs(expected));
}



TEST(SpringWork, audit_of_a_spinning_pair_closes)
{
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      test::FixedBaseRun run(test::square_blocks(2, 1), spinning_pair(preset), {});
      set_in_motion(run.model, run.state);
      const double start = run.state.energy.kinetic;
      ASSERT_TRUE(run.run(2., 1e-3));
      EXPECT_NEAR(run.state.energy.balance(), start, 2e-5 * start) << preset;
      // A filter takes the turning back: with each body turns what it remembers.
      const double lost = (run.model.newmark.gamma - 0.5 - run.model.newmark.filter) * 1e-3 *
                          std::pow(6., 4) * 2220. * 0.5 * 2.;
      EXPECT_NEAR(start - run.state.energy.kinetic, lost, 0.1 * lost + 5e-5 * start) << preset;
    }
}
