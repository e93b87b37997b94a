// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/continuum.h>
#include <hybrid/scene/boundary/fixed_base.h>
#include <hybrid/scene/boundary/fixed_side.h>
#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/rigid_base.h>
#include <hybrid/scene/boundary/roller_side.h>

#include "rectangle_mesh.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;
  using scene::compliant_base;
  using scene::fixed_base;
  using scene::fixed_side;
  using scene::free_field_side;
  using scene::rigid_base;
  using scene::roller_side;
  using scene::viscous_side;

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
        const auto            s      = continuum.surface_stiffness(dt).dense().ldlt();
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
  for (const auto &base : {compliant_base(), rigid_base(), fixed_base()})
    for (const auto &sides : {viscous_side(), free_field_side(), roller_side(), fixed_side()})
      for (const char *scheme : {"dissipative", "filtered", "trapezoidal", "fourth order", "shi"})
        {
          auto scene                         = test::rock_scene();
          scene.time.newmark                 = preset(scheme);
          scene.continuum.base               = base;
          scene.continuum.sides              = sides;
          scene.continuum.rayleigh_mass      = 0.5;
          scene.continuum.rayleigh_stiffness = 1e-4;
          scene.bedding.names                = {"bedding_1"};
          scene.motion.angle                 = 30.;
          EXPECT_LT(residual(scene), 1e-9) << scheme << ' ' << base.name << ' ' << sides.name;
        }
}


// The recipe of the developer guide: sides that absorb what arrives along their normal and hold
// the rest, a base that absorbs and brings nothing.
TEST(ContinuumEnergy, closes_with_another_side_and_base)
{
  scene::SideBoundary sides{"normal dashpots", "normal dashpots"};
  sides.holds_y         = true;
  sides.normal_dashpots = 0.8;
  scene::BaseBoundary base{"quiet", "base that waves leave through"};
  base.is_compliant = true;
  for (const char *scheme : {"dissipative", "filtered", "trapezoidal", "fourth order", "shi"})
    {
      auto scene            = test::rock_scene();
      scene.time.newmark    = preset(scheme);
      scene.continuum.base  = base;
      scene.continuum.sides = sides;
      EXPECT_LT(residual(scene), 1e-9) << scheme;
    }
}


TEST(ContinuumEnergy, a_base_that_takes_no_motion_lets_none_in)
{
  auto scene                        = test::rock_scene();
  scene.continuum.base.takes_motion = false; // compliant
  const auto section =
    test::rectangle_mesh(test::equal_spacing(0., 60., 5), test::equal_spacing(-30., 30., 4));
  Continuum continuum(section, scene, {shaking(), scene.motion}, MPI_COMM_WORLD);
  auto      state = continuum.initial_state();
  for (int k = 0; k < 20; ++k)
    continuum.step(state, 2e-3);
  for (const double v : state.velocity)
    EXPECT_EQ(v, 0.);
}


TEST(ContinuumEnergy, closes_with_springs_on_the_boundary)
{
  for (const auto &base : {compliant_base(), rigid_base(), fixed_base()})
    for (const auto &sides : {viscous_side(), free_field_side()})
      for (const char *scheme : {"dissipative", "filtered", "trapezoidal", "fourth order", "shi"})
        {
          auto scene                         = test::rock_scene();
          scene.time.newmark                 = preset(scheme);
          scene.continuum.base               = base;
          scene.continuum.sides              = sides;
          scene.continuum.rayleigh_stiffness = 1e-4;
          scene.continuum.boundary_springs   = true;
          scene.motion.angle                 = 30.;
          EXPECT_LT(residual(scene), 1e-9) << scheme << ' ' << base.name << ' ' << sides.name;
        }
}


TEST(ContinuumEnergy, closes_while_planes_slip_and_open)
{
  for (const auto &base : {compliant_base(), rigid_base()})
    for (const auto &sides : {viscous_side(), roller_side()})
      for (const double damping : {0., 1e-4})
        for (const char *scheme : {"dissipative", "filtered", "trapezoidal", "shi"})
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
            EXPECT_LT(residual(scene), 1e-9) << scheme << ' ' << base.name << ' ' << sides.name;
          }
}


TEST(ContinuumEnergy, closes_with_maxwell_damping)
{
  for (const auto &base : {compliant_base(), rigid_base(), fixed_base()})
    for (const auto &sides : {viscous_side(), free_field_side(), roller_side()})
      for (const bool slips : {false, true})
        for (const char *scheme : {"dissipative", "filtered", "trapezoidal", "fourth order", "shi"})
          {
            if (slips && (sides.has_free_field || std::string(scheme) == "fourth order"))
              continue;
            auto scene                          = test::rock_scene();
            scene.time.newmark                  = preset(scheme);
            scene.continuum.base                = base;
            scene.continuum.sides               = sides;
            scene.continuum.rayleigh_stiffness  = slips ? 1e-4 : 0.;
            scene.maxwell.bedrock_ratio         = 0.1;
            scene.maxwell.lowest                = 5.;
            scene.maxwell.highest               = 50.;
            scene.bedding.names                 = {"bedding_1"};
            scene.bedding.slips                 = slips;
            scene.bedding.friction_angle        = 30.;
            scene.bedding.cohesion              = 5e3;
            scene.bedding.tensile_strength      = 5e3;
            scene.bedding.initial_normal_stress = 1e4;
            EXPECT_LT(residual(scene), 1e-9) << scheme << ' ' << base.name << ' ' << sides.name;
          }
}


TEST(ContinuumEnergy, maxwell_branches_lose_in_every_step)
{
  auto scene                  = test::rock_scene();
  scene.time.newmark          = Newmark::preset("filtered");
  scene.continuum.base        = fixed_base();
  scene.continuum.sides       = fixed_side();
  scene.maxwell.bedrock_ratio = 0.25;
  const auto section =
    test::rectangle_mesh(test::equal_spacing(0., 60., 5), test::equal_spacing(-30., 30., 4));
  Continuum continuum(section, scene, {}, MPI_COMM_WORLD);
  auto      state = continuum.initial_state();
  for (std::size_t i = 0; i < state.velocity.size(); ++i)
    state.velocity[i] = std::sin(0.7 * i);
  for (int k = 0; k < 200; ++k)
    {
      const double before = state.energy.damping_loss;
      continuum.step(state, k % 7 == 0 ? 5e-2 : 1e-3); // longer than the shortest relaxation, too
      EXPECT_GT(state.energy.damping_loss, before);
    }
}


TEST(ContinuumEnergy, trapezoidal_rule_keeps_energy_exactly)
{
  auto scene            = test::rock_scene();
  scene.time.newmark    = Newmark::preset("trapezoidal");
  scene.continuum.base  = fixed_base();
  scene.continuum.sides = fixed_side();
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
