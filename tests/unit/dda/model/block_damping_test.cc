// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/model/block_damping.h>
#include <hybrid/dda/step/initial_state.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// Circular frequency of the shear vibration of a free square [1/s]: G A over rho A (h^2 +
  /// h^2)/48.
  double shear_frequency(const scene::SceneParameters &scene, const double size)
  {
    const Material &rock  = scene.materials.at("rock");
    const double    shear = rock.young_modulus / (2. * (1. + rock.poisson_ratio));
    return std::sqrt(24. * shear / rock.density) / size;
  }
} // namespace



TEST(BlockDamping, a_loose_block_does_not_ring)
{
  const double           size = 2., rate = 1e-3;
  scene::SceneParameters scene = block_parameters(30., 5e9);
  scene.environment.gravity    = 0.;
  scene.time.newmark           = Newmark::preset("trapezoidal");
  const double w               = shear_frequency(scene, size);
  for (const double ratio : {1., 0.25})
    {
      scene.blocks.loose_damping = ratio;
      FixedBaseRun run(square_blocks(1, 1, size), scene, {});
      EXPECT_NEAR(run.model.blocks[0].loose_damping_time, 2. * ratio / w, 1e-12 / w);
      run.state.blocks[0].velocity[5]     = rate;
      run.state.blocks[0].acceleration[5] = -2. * ratio * w * rate;
      ASSERT_TRUE(run.run(1. / w, 1e-3 / w));
      // At w t = 1: e = v0/w exp(-1) where critical, v0/w_d exp(-ratio) sin(w_d/w) below.
      const double damped   = std::sqrt(1. - ratio * ratio);
      const double expected = std::exp(-ratio) * (ratio < 1. ? std::sin(damped) / damped : 1.);
      const double strain   = run.state.blocks[0].stress[2] / run.model.blocks[0].elasticity(2, 2);
      EXPECT_NEAR(strain * w / rate, expected, 2e-3 * expected) << ratio;
      const double start = 0.5 * rate * rate * run.model.blocks[0].sxx / 2.;
      EXPECT_NEAR(run.state.energy.damping_loss + run.state.energy.kinetic +
                    run.state.energy.strain,
                  start,
                  5e-3 * start);
    }
}



TEST(BlockDamping, of_a_bonded_block_is_its_own_until_the_last_joint_fails)
{
  scene::SceneParameters scene   = block_parameters(30.);
  scene.blocks.bonded            = true;
  scene.blocks.damping_ratio     = 0.01;
  scene.blocks.damping_frequency = 10.;
  const Model         model      = build_model(square_blocks(3, 1), scene, {});
  DdaState            state      = initial_state(model);
  const double        bonded = 0.01 / (M_PI * 10.), loose = model.blocks[0].loose_damping_time;
  std::vector<double> times;
  ASSERT_EQ(state.joints.size(), 2u);
  ASSERT_GT(loose, 0.);
  block_damping_times(model, state, times);
  EXPECT_EQ(times, std::vector<double>(3, bonded));
  state.joints[0].failure = FailureKind::shear;
  block_damping_times(model, state, times);
  const int alone = model.joints[1].block == 0 || model.joints[1].other == 0 ? 2 : 0;
  EXPECT_EQ(times[alone], std::max(loose, bonded));
  EXPECT_EQ(times[1], bonded);
  EXPECT_EQ(times[2 - alone], bonded);
}
