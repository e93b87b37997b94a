// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/continuum.h>

#include "rectangle_mesh.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;
  using scene::BaseBoundary;
  using scene::SideBoundary;

  scene::Motion shaking()
  {
    std::vector<double> a;
    for (int i = 0; i < 100; ++i)
      a.push_back(3. * std::sin(0.4 * i) * std::exp(-0.02 * i));
    return {2e-3, a};
  }

  /// |sum of all terms| over the largest of them after random forces, half of them of contacts, of
  /// which one in five ends with a joint that tears, steps of two sizes and shaking.
  double residual(const scene::SceneParameters &scene)
  {
    auto section =
      test::rectangle_mesh(test::equal_spacing(0., 60., 5), test::equal_spacing(-30., 30., 4));
    section.lines["bedding_1"] = {{12, 13}, {13, 14}, {14, 15}};
    test::add_block(section);
    Continuum    continuum(section, scene, {shaking(), scene.motion}, MPI_COMM_WORLD);
    auto         state = continuum.initial_state();
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> random(-1e6, 1e6);
    Eigen::VectorXd                        bonds(2 * continuum.surface_nodes().size());
    Eigen::VectorXd                        contacts = bonds;
    const double                           weight   = 0.5 / scene.time.newmark.beta;
    for (int k = 0; k < 60; ++k)
      {
        const double dt = k % 20 < 15 ? 2e-3 : 1e-3;
        for (int i = 0; i < bonds.size(); ++i)
          {
            bonds[i]    = random(generator);
            contacts[i] = random(generator);
          }
        const Eigen::VectorXd lambda = bonds + weight * contacts;
        const auto            s      = continuum.surface_stiffness(dt).ldlt();
        Eigen::VectorXd       u      = s.solve(continuum.predict(state, dt) + lambda);
        auto                  slip   = continuum.solve_slip(state, dt, u);
        for (int round = 0; round < 5 && slip == SlipStatus::changed; ++round)
          {
            u    = s.solve(continuum.surface_load() + lambda);
            slip = continuum.solve_slip(state, dt, u);
          }
        EXPECT_EQ(slip, SlipStatus::settled);
        const Eigen::VectorXd ended = contacts + (k % 5 == 0 ? 0.5 : 0.) * bonds;
        continuum.correct(state, dt, u, {bonds + contacts, contacts, ended});
      }
    if (scene.bedding.slips)
      {
        EXPECT_GT(state.energy.bedding_loss, 0.);
      }
    state.energy     = continuum.audit_energy(state);
    const auto  &e   = state.energy;
    const double sum = e.kinetic + e.strain + e.boundary_springs - e.input_work - e.surface_work +
                       e.boundary_loss + e.damping_loss + e.integration_loss + e.bedding_loss +
                       e.bedding_static_stress;
    double largest = 0.;
    for (const double term : {e.kinetic, e.strain, e.input_work, e.surface_work, e.boundary_loss})
      largest = std::max(largest, std::abs(term));
    return std::abs(sum) / largest;
  }

  Newmark preset(const std::string &scheme)
  {
    Newmark newmark = Newmark::preset(scheme);
    if (scheme == "fourth order")
      newmark.corrected_step = 2e-3;
    return newmark;
  }
} // namespace


TEST(ContinuumEnergy, closes_with_every_boundary_and_scheme)
{
  for (const auto base : {BaseBoundary::compliant, BaseBoundary::rigid, BaseBoundary::fixed})
    for (const auto sides : {SideBoundary::viscous,
                             SideBoundary::free_field,
                             SideBoundary::roller,
                             SideBoundary::fixed})
      for (const char *scheme : {"dissipative", "trapezoidal", "fourth order", "shi"})
        {
          auto scene                         = test::rock_scene();
          scene.time.newmark                 = preset(scheme);
          scene.continuum.base               = base;
          scene.continuum.sides              = sides;
          scene.continuum.rayleigh_mass      = 0.5;
          scene.continuum.rayleigh_stiffness = 1e-4;
          scene.bedding.names                = {"bedding_1"};
          scene.motion.angle                 = 30.;
          EXPECT_LT(residual(scene), 1e-9)
            << scheme << ' ' << static_cast<int>(base) << ' ' << static_cast<int>(sides);
        }
}


TEST(ContinuumEnergy, closes_with_springs_on_the_boundary)
{
  for (const auto base : {BaseBoundary::compliant, BaseBoundary::rigid, BaseBoundary::fixed})
    for (const auto sides : {SideBoundary::viscous, SideBoundary::free_field})
      for (const char *scheme : {"dissipative", "trapezoidal", "fourth order", "shi"})
        {
          auto scene                         = test::rock_scene();
          scene.time.newmark                 = preset(scheme);
          scene.continuum.base               = base;
          scene.continuum.sides              = sides;
          scene.continuum.rayleigh_stiffness = 1e-4;
          scene.continuum.boundary_springs   = true;
          scene.motion.angle                 = 30.;
          EXPECT_LT(residual(scene), 1e-9)
            << scheme << ' ' << static_cast<int>(base) << ' ' << static_cast<int>(sides);
        }
}


TEST(ContinuumEnergy, closes_while_planes_slip_and_open)
{
  for (const auto base : {BaseBoundary::compliant, BaseBoundary::rigid})
    for (const auto sides : {SideBoundary::viscous, SideBoundary::roller})
      for (const double damping : {0., 1e-4})
        for (const char *scheme : {"dissipative", "trapezoidal", "shi"})
          {
            auto scene                          = test::rock_scene();
            scene.time.newmark                  = Newmark::preset(scheme);
            scene.continuum.base                = base;
            scene.continuum.sides               = sides;
            scene.continuum.rayleigh_stiffness  = damping;
            scene.bedding.names                 = {"bedding_1"};
            scene.bedding.slips                 = true;
            scene.bedding.friction_angle        = 30.;
            scene.bedding.cohesion              = 5e3;
            scene.bedding.tensile_strength      = 5e3;
            scene.bedding.initial_normal_stress = 1e4;
            EXPECT_LT(residual(scene), 1e-9)
              << scheme << ' ' << static_cast<int>(base) << ' ' << static_cast<int>(sides);
          }
}


TEST(ContinuumEnergy, trapezoidal_rule_keeps_energy_exactly)
{
  auto scene            = test::rock_scene();
  scene.time.newmark    = Newmark::preset("trapezoidal");
  scene.continuum.base  = BaseBoundary::fixed;
  scene.continuum.sides = SideBoundary::fixed;
  const auto section =
    test::rectangle_mesh(test::equal_spacing(0., 60., 5), test::equal_spacing(-30., 30., 4));
  Continuum continuum(section, scene, {}, MPI_COMM_WORLD);
  auto      state = continuum.initial_state();
  for (std::size_t i = 0; i < state.velocity.size(); ++i)
    state.velocity[i] = std::sin(0.7 * i);
  continuum.step(state, 1e-3); // supports take their part of the initial velocity
  state.energy        = continuum.audit_energy(state);
  const double before = state.energy.kinetic + state.energy.strain;
  for (int k = 0; k < 500; ++k)
    continuum.step(state, 1e-3);
  state.energy = continuum.audit_energy(state);
  EXPECT_NEAR((state.energy.kinetic + state.energy.strain) / before, 1., 1e-9);
  EXPECT_NEAR(state.energy.integration_loss / before, 0., 1e-12);
}
