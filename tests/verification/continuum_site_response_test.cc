// SPDX-License-Identifier: GPL-3.0-or-later
// A soft layer over a half space, vertically incident S and P waves, compliant base. Closed form:
// surface over outcrop motion is 1 / |cos kH + i a sin kH|, a = impedance ratio of layer and half
// space.
#include <gtest/gtest.h>

#include "continuum_check.h"
#include "rectangle_mesh.h"

#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/rigid_base.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double thickness = 40.;

  scene::SceneParameters layer_scene(const double angle)
  {
    auto scene = test::rock_scene();
    auto soft  = test::rock_material();
    soft.young_modulus *= 0.04; // 200 m/s
    scene.materials["soft"]              = soft;
    scene.continuum.region_material["*"] = "soft";
    scene.continuum.half_space_material  = "rock";
    scene.continuum.sides                = scene::free_field_side();
    scene.motion.angle                   = angle;
    scene.time.newmark                   = Newmark::preset("trapezoidal");
    return scene;
  }

  void expect_amplification(const double angle, const int component, const double speed)
  {
    const double        dt     = 1e-3;
    const auto          motion = test::ricker(speed / (4. * thickness) * 1.5, dt);
    const auto          scene  = layer_scene(angle);
    Continuum           continuum(test::rectangle_mesh(test::equal_spacing(0., 20., 2),
                                             test::equal_spacing(0., thickness, 10)),
                        scene,
                        {motion, scene.motion},
                        MPI_COMM_WORLD);
    const auto          top   = continuum.point({10., thickness});
    auto                state = continuum.initial_state();
    std::vector<double> surface, outcrop;
    for (int k = 0; k < 8000; ++k)
      {
        continuum.step(state, dt);
        surface.push_back(continuum.sample(state, top).velocity[component]);
        outcrop.push_back(motion.velocity(state.time));
      }
    const double f0 = speed / (4. * thickness);
    for (const double f : {0.5 * f0, f0, 1.7 * f0})
      {
        const double kh = 2. * test::pi * f * thickness / speed;
        const double expected =
          1. / std::abs(std::complex<double>(std::cos(kh), 0.2 * std::sin(kh)));
        const double found =
          std::abs(test::fourier(surface, dt, f) / test::fourier(outcrop, dt, f));
        EXPECT_NEAR(found / expected, 1., 0.01) << "at " << f << " Hz";
      }
  }
} // namespace


TEST(SiteResponse, shear_wave)
{
  expect_amplification(0., 0, 200.);
}


TEST(SiteResponse, p_wave)
{
  expect_amplification(90., 1, 200. * std::sqrt(3.));
}


TEST(SiteResponse, rigid_base_amplifies_by_one_over_cosine)
{
  auto scene           = layer_scene(0.);
  scene.continuum.base = scene::rigid_base();
  // Well below resonance, ramped up: 1 / cos kH at half the first frequency is sqrt 2.
  const double        dt = 2e-3, f = 0.5 * 200. / (4. * thickness);
  std::vector<double> a;
  for (int i = 0; i < 8000; ++i)
    a.push_back(std::min(1., i * dt / 8.) * std::sin(2. * test::pi * f * i * dt));
  scene.continuum.rayleigh_mass = 0.5; // so that the free vibration dies out
  const scene::Motion motion(dt, a);
  Continuum           continuum(test::rectangle_mesh(test::equal_spacing(0., 20., 2),
                                           test::equal_spacing(0., thickness, 10)),
                      scene,
                      {motion, scene.motion},
                      MPI_COMM_WORLD);
  const auto          top   = continuum.point({10., thickness});
  auto                state = continuum.initial_state();
  double              peak  = 0.;
  while (state.time < 15.9)
    {
      continuum.step(state, dt);
      if (state.time > 13.)
        peak = std::max(peak, std::abs(continuum.sample(state, top).acceleration.x()));
    }
  // k with C = alpha M: rho (w^2 - i alpha w) = G k^2.
  const double               w = 2. * test::pi * f;
  const std::complex<double> kh =
    std::sqrt(std::complex<double>(w * w, -0.5 * w)) / 200. * thickness;
  EXPECT_NEAR(peak * std::abs(std::cos(kh)), 1., 0.01);
}
