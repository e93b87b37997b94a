// SPDX-License-Identifier: GPL-3.0-or-later
// One elastic joint in the path of a plane wave: |T| = 1 / sqrt(1 + (w Z / 2 k)^2), Z = rho c, k
// the joint's normal (P) or shear (S) stiffness.
#include <gtest/gtest.h>

#include "continuum_check.h"
#include "rectangle_mesh.h"

#include <hybrid/scene/boundary/roller_side.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double length = 1000., joint_at = 300.;
  constexpr int    cells = 100;

  /// A bar along y for P waves. For S waves a bar along x whose "base" is its left end, so that
  /// rollers (no horizontal motion) along its long edges leave u_y(x).
  scene::SectionMesh bar(const bool along_x)
  {
    const auto long_side  = test::equal_spacing(0., length, cells);
    const auto short_side = test::equal_spacing(0., 20., 2);
    auto       mesh       = along_x ? test::rectangle_mesh(long_side, short_side)
                                    : test::rectangle_mesh(short_side, long_side);
    const int  row        = static_cast<int>(joint_at / length * cells);
    for (int i = 0; i < 2; ++i)
      mesh.lines["bedding_1"].push_back(
        along_x ? std::array<int, 2>{i * (cells + 1) + row, (i + 1) * (cells + 1) + row}
                : std::array<int, 2>{3 * row + i, 3 * row + i + 1});
    if (along_x)
      {
        const auto turned    = mesh.lines;
        mesh.lines["base"]   = turned.at("left");
        mesh.lines["ground"] = turned.at("right");
        mesh.lines["left"]   = turned.at("base");
        mesh.lines["right"]  = turned.at("ground");
      }
    return mesh;
  }

  /// Velocity just behind the joint until the wave comes back from the free end.
  std::vector<double> transmitted(const bool jointed, const bool shear, const double dt)
  {
    auto scene                     = test::rock_scene();
    scene.continuum.sides          = scene::roller_side();
    scene.motion.angle             = 90.;
    scene.time.newmark             = Newmark::preset("trapezoidal");
    scene.bedding.normal_stiffness = shear ? 1e12 : 1.2e8;
    scene.bedding.shear_stiffness  = shear ? 6e7 : 1e12;
    if (jointed)
      scene.bedding.names = {"bedding_1"};
    Continuum continuum(bar(shear), scene, {test::ricker(10., dt), scene.motion}, MPI_COMM_WORLD);
    const double        at    = joint_at + 15.;
    const auto          probe = continuum.point(shear ? Vec2(at, 10.) : Vec2(10., at));
    auto                state = continuum.initial_state();
    std::vector<double> velocity;
    const double        speed = shear ? 1000. : 1000. * std::sqrt(3.);
    while (state.time < (2. * length - at) / speed)
      {
        continuum.step(state, dt);
        velocity.push_back(continuum.sample(state, probe).velocity.y());
      }
    return velocity;
  }

  void expect_transmission(const bool shear, const double impedance, const double stiffness)
  {
    const double dt    = 2.5e-4;
    const auto   whole = transmitted(false, shear, dt), jointed = transmitted(true, shear, dt);
    for (const double f : {5., 8., 12., 16.})
      {
        const double expected =
          1. / std::sqrt(1. + std::pow(2. * test::pi * f * impedance / (2. * stiffness), 2));
        const double found = std::abs(test::fourier(jointed, dt, f) / test::fourier(whole, dt, f));
        EXPECT_NEAR(found / expected, 1., 0.01) << "at " << f << " Hz, expected " << expected;
      }
  }
} // namespace


TEST(ElasticJoint, shear_wave)
{
  expect_transmission(true, 2000. * 1000., 6e7);
}


TEST(ElasticJoint, p_wave)
{
  expect_transmission(false, 2000. * 1000. * std::sqrt(3.), 1.2e8);
}
