// SPDX-License-Identifier: GPL-3.0-or-later
// Pulses that leave through viscous boundaries at normal incidence: less than 0.5 % comes back.
#include <gtest/gtest.h>

#include "continuum_check.h"
#include "rectangle_mesh.h"

#include <hybrid/scene/boundary/free_field_side.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  const double c_s = 1000., c_p = 1000. * std::sqrt(3.);

  double pulse(const double x)
  {
    return std::exp(-x * x / (2. * 20. * 20.));
  }

  double pulse_slope(const double x)
  {
    return -x / (20. * 20.) * pulse(x);
  }

  double pulse_curvature(const double x)
  {
    return (x * x / (20. * 20.) - 1.) / (20. * 20.) * pulse(x);
  }
} // namespace


// Base: a wave sent in through the base, reflected at the free surface, must leave for good.
TEST(Absorption, wave_leaves_through_the_base)
{
  for (const int component : {0, 1})
    {
      auto scene             = test::rock_scene();
      scene.motion.angle     = 90. * component;
      scene.continuum.sides  = scene::free_field_side();
      scene.time.newmark     = Newmark::preset("trapezoidal");
      const double        dt = 5e-4;
      Continuum           continuum(test::rectangle_mesh(test::equal_spacing(0., 20., 2),
                                               test::equal_spacing(0., 400., 40)),
                          scene,
                          {test::ricker(8., dt), scene.motion},
                          MPI_COMM_WORLD);
      const auto          top   = continuum.point({10., 400.});
      auto                state = continuum.initial_state();
      const double        speed = component == 0 ? c_s : c_p;
      std::vector<double> before, after;
      while (state.time < 0.375 + 1200. / speed)
        {
          continuum.step(state, dt);
          (state.time < 0.375 + 500. / speed ? before : after)
            .push_back(continuum.sample(state, top).velocity[component]);
        }
      EXPECT_NEAR(test::largest(before),
                  test::largest([&] {
                    std::vector<double> v;
                    const auto          m = test::ricker(8., dt);
                    for (int i = 0; i < 800; ++i)
                      v.push_back(m.velocity(i * dt));
                    return v;
                  }()),
                  0.01 * test::largest(before)); // the surface moves like the outcrop
      EXPECT_LT(test::largest(after), 0.005 * test::largest(before));
    }
}


// Sides: a plane wave along x, given as initial condition in a box so high that what its free top
// and its base do (with tall elements: noise that runs ahead of the P wave) has not come to
// mid-height when what a side reflects passes there.
TEST(Absorption, wave_leaves_through_the_sides)
{
  for (const int component : {0, 1})
    {
      auto scene          = test::rock_scene();
      scene.time.newmark  = Newmark::preset("trapezoidal");
      const double speed  = component == 0 ? c_p : c_s;
      const double height = component == 0 ? 1600. : 2600.;
      Continuum    continuum(test::rectangle_mesh(test::equal_spacing(0., 300., 30),
                                               test::equal_spacing(0., height, 40)),
                          scene,
                          {},
                          MPI_COMM_WORLD);
      auto         state  = continuum.initial_state();
      const auto   points = continuum.picture(state).points;
      for (std::size_t k = 0; k < points.size(); ++k)
        {
          const double      x   = points[k].x() - 150.;
          const std::size_t i   = 2 * k + component;
          state.displacement[i] = pulse(x);
          state.velocity[i]     = -speed * pulse_slope(x);
          state.acceleration[i] = speed * speed * pulse_curvature(x);
        }
      std::vector<Continuum::Point> probes;
      for (const double x : {30., 90., 150., 210., 270.})
        probes.push_back(continuum.point({x, 0.5 * height}));
      double left = 0.;
      while (state.time < 320. / speed)
        {
          continuum.step(state, 0.5 / speed);
          for (const auto &probe : probes)
            if (state.time > 250. / speed)
              left = std::max(left, std::abs(continuum.sample(state, probe).velocity[component]));
        }
      EXPECT_LT(left, 0.005 * speed * std::abs(pulse_slope(20.))) << "component " << component;
    }
}
