// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/continuum.h>
#include <hybrid/continuum/point_loads.h>
#include <hybrid/scene/boundary/rigid_base.h>
#include <hybrid/scene/input_error.h>

#include "rectangle_mesh.h"

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  scene::PointLoadParameters loads_at(const std::vector<Vec2> &positions)
  {
    scene::PointLoadParameters parameters;
    parameters.frequency = 10.;
    parameters.start     = 0.05;
    for (const Vec2 &x : positions)
      parameters.loads.push_back({"load", x, Vec2(3e5, -1e6)});
    return parameters;
  }


  Continuum rock_with(const scene::SceneParameters &scene)
  {
    return {test::rectangle_mesh(test::equal_spacing(0., 60., 4), test::equal_spacing(0., 40., 3)),
            scene,
            {},
            MPI_COMM_WORLD};
  }
} // namespace


TEST(PointLoads, ricker_wavelet)
{
  const PointLoads loads(loads_at({}));
  EXPECT_TRUE(loads.empty());
  EXPECT_EQ(loads.factor(0.049), 0.);
  EXPECT_DOUBLE_EQ(loads.factor(0.2), 1.);
  // Zero where 2 s^2 = 1, least where s^2 = 3/2.
  EXPECT_NEAR(loads.factor(0.2 + std::sqrt(0.5) / (M_PI * 10.)), 0., 1e-14);
  EXPECT_NEAR(loads.factor(0.2 - std::sqrt(1.5) / (M_PI * 10.)), -2. * std::exp(-1.5), 1e-14);
}


TEST(PointLoads, shares_of_the_nodes_add_up_to_the_force)
{
  PointLoads loads(loads_at({}));
  loads.add({0, 2, 3}, {0.5, -0.125, 0.625}, Vec2(3e5, -1e6));
  std::vector<double> force(8, 0.), zero(8, 0.), moved(8, 0.);
  loads.add_forces(0.2, force);
  EXPECT_DOUBLE_EQ(force[0] + force[2] + force[4] + force[6], 3e5);
  EXPECT_DOUBLE_EQ(force[1] + force[3] + force[5] + force[7], -1e6);
  for (int i = 1; i < 8; i += 2)
    moved[i] = -1e-3;
  EXPECT_DOUBLE_EQ(loads.work_of_peak(zero, moved), 1e3);
}


// Two equal loads do twice what one does; the energy of every term closes with each scheme.
TEST(PointLoads, in_the_rock)
{
  for (const char *scheme : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      auto scene                         = test::rock_scene();
      scene.time.newmark                 = Newmark::preset(scheme);
      scene.continuum.rayleigh_stiffness = 1e-4;
      double       top[2];
      const Vec2   at(25., 40.);
      const double dt = 2e-3;
      for (int n : {1, 2})
        {
          scene.point_loads = loads_at(std::vector<Vec2>(n, at));
          Continuum  rock   = rock_with(scene);
          auto       state  = rock.initial_state();
          const auto point  = rock.point(at);
          for (int k = 0; k < 140; ++k)
            rock.step(state, k < 60 ? dt : 0.5 * dt);
          top[n - 1]               = rock.sample(state, point).displacement.y();
          state.energy             = rock.audit_energy(state);
          const ContinuumEnergy &e = state.energy;
          EXPECT_GT(e.input_work, 0.);
          EXPECT_NEAR(e.kinetic + e.strain + e.boundary_loss + e.damping_loss + e.integration_loss,
                      e.input_work,
                      1e-9 * e.input_work);
        }
      EXPECT_LT(top[0], 0.); // downwards at the peak, t = 0.2 s
      EXPECT_NEAR(top[1], 2. * top[0], 1e-12 * std::abs(top[0]));
    }
}


TEST(PointLoads, outside_or_on_a_moving_base_is_refused)
{
  auto scene        = test::rock_scene();
  scene.point_loads = loads_at({Vec2(25., 60.)});
  EXPECT_THROW(rock_with(scene), InputError);
  scene.point_loads    = loads_at({Vec2(25., 0.)});
  scene.continuum.base = scene::rigid_base();
  EXPECT_THROW(rock_with(scene), InputError);
}
