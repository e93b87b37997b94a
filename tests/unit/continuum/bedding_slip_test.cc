// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/continuum.h>
#include <hybrid/scene/boundary/roller_side.h>

#include "rectangle_mesh.h"

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double friction = 30.;

  /// 60 m of rock with a plane from side to side half way up.
  scene::SectionMesh section()
  {
    auto mesh =
      test::rectangle_mesh(test::equal_spacing(0., 60., 6), test::equal_spacing(0., 40., 4));
    for (int i = 0; i < 6; ++i)
      mesh.lines["bedding_1"].push_back({14 + i, 15 + i});
    test::add_block(mesh);
    return mesh;
  }


  scene::SceneParameters parameters(const double cohesion)
  {
    auto scene                     = test::rock_scene();
    scene.bedding.names            = {"bedding_1"};
    scene.bedding.slips            = true;
    scene.bedding.friction_angle   = friction;
    scene.bedding.cohesion         = cohesion;
    scene.bedding.tensile_strength = cohesion;
    return scene;
  }


  /// Horizontal forces on the ground beside the weight.
  Eigen::VectorXd push(const Continuum &continuum)
  {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * continuum.surface_nodes().size());
    for (Eigen::Index i = 0; i < force.size(); i += 2)
      force[i] = 3e7;
    return force;
  }


  /// Largest |tau| - sigma tan(phi) of the plane [Pa].
  double excess(const Continuum &continuum, const ContinuumState &state)
  {
    const auto values  = continuum.bedding_values(state, continuum.slipping_planes()[0]);
    double     largest = -1e300;
    for (std::size_t i = 0; i < values.slip.size(); ++i)
      largest = std::max(largest,
                         std::abs(values.shear_stress[i]) -
                           std::tan(friction * M_PI / 180.) * values.normal_stress[i]);
    return largest;
  }
} // namespace


TEST(BeddingSlip, static_tractions_are_within_the_strength_and_stay)
{
  Continuum strong(section(), parameters(1e12), {}, MPI_COMM_WORLD);
  EXPECT_EQ(strong.solve_static_state(push(strong), 9.81).slipping, 0);
  EXPECT_GT(excess(strong, strong.initial_state()), 1e4);

  Continuum  weak(section(), parameters(0.), {}, MPI_COMM_WORLD);
  const auto rest = weak.solve_static_state(push(weak), 9.81);
  EXPECT_TRUE(rest.equilibrium);
  EXPECT_GT(rest.slipping, 0);
  auto state = weak.initial_state();
  EXPECT_LT(excess(weak, state), 1e-3);
  for (int k = 0; k < 20; ++k)
    ASSERT_TRUE(weak.step(state, 1e-3));
  for (const double v : state.velocity)
    EXPECT_NEAR(v, 0., 1e-12);
}


TEST(BeddingSlip, sides_that_hold_rock_back_are_told)
{
  // What friction does not hold hangs on the left side and leans on the right one, above the plane.
  Continuum  weak(section(), parameters(0.), {}, MPI_COMM_WORLD);
  const auto pushed = weak.solve_static_state(push(weak), 9.81);
  ASSERT_TRUE(pushed.equilibrium);
  EXPECT_GT(pushed.pull, 1e7);
  EXPECT_LT(pushed.pull, 7 * 3e7);
  EXPECT_EQ(pushed.pulled.x(), 0.);
  EXPECT_NEAR(pushed.pulled.y(), 30., 1e-9);

  // Rock under its weight alone presses; along the slope of the ground (0.1 g) it hangs on one
  // side.
  Continuum             strong(section(), parameters(1e12), {}, MPI_COMM_WORLD);
  const Eigen::VectorXd none = 0. * push(strong);
  EXPECT_EQ(strong.solve_static_state(none, 9.81).pull, 0.);
  EXPECT_EQ(strong.solve_static_state(none, 9.81, 0.01).pull, 0.); // the weight's pressure is more
  EXPECT_GT(strong.solve_static_state(none, 9.81, 9.81).pull, 0.);
}


TEST(BeddingSlip, what_has_slipped_at_rest_stays_whatever_the_weight)
{
  // Points that are torn and bear nothing have tractions of round-off alone.
  for (int k = 0; k <= 16; ++k)
    {
      Continuum weak(section(), parameters(0.), {}, MPI_COMM_WORLD);
      ASSERT_TRUE(weak.solve_static_state(push(weak), 9. + 0.1 * k).equilibrium);
      auto state = weak.initial_state();
      for (int step = 0; step < 3; ++step)
        ASSERT_TRUE(weak.step(state, 1e-3)) << k;
    }
}


TEST(BeddingSlip, strong_planes_are_elastic_joints)
{
  auto elastic          = parameters(1e12);
  elastic.bedding.slips = false;
  std::vector<double> a;
  for (int i = 0; i < 100; ++i)
    a.push_back(std::sin(0.2 * i));
  const scene::Motion shaking(2e-3, a);
  Continuum           one(section(), elastic, {shaking, elastic.motion}, MPI_COMM_WORLD);
  Continuum           other(section(), parameters(1e12), {shaking, elastic.motion}, MPI_COMM_WORLD);
  auto                s = one.initial_state(), t = other.initial_state();
  for (int k = 0; k < 60; ++k)
    {
      ASSERT_TRUE(one.step(s, 2e-3));
      ASSERT_TRUE(other.step(t, 2e-3));
    }
  EXPECT_TRUE(s.slip.jump.empty());
  EXPECT_TRUE(one.slipping_planes().empty());
  EXPECT_EQ(s.displacement, t.displacement);
  EXPECT_EQ(t.energy.bedding_loss, 0.);
}


TEST(BeddingSlip, a_plane_that_opens_loses_the_energy_of_its_cut_off_only)
{
  auto scene                          = parameters(2e4);
  scene.continuum.sides               = scene::roller_side();
  scene.bedding.normal_stiffness      = 1e9;
  scene.bedding.initial_normal_stress = 1e5;
  scene.motion.angle                  = 90.;
  std::vector<double> a;
  for (int i = 0; i <= 200; ++i)
    a.push_back(30. * std::sin(0.1 * M_PI * i)); // 10 Hz
  const scene::Motion shaking(5e-3, a);
  for (const double dt : {1e-3, 2e-3})
    {
      Continuum continuum(section(), scene, {shaking, scene.motion}, MPI_COMM_WORLD);
      auto      state  = continuum.initial_state();
      int       opened = 0, closed = 0;
      bool      open = false;
      while (state.time < 0.5)
        {
          ASSERT_TRUE(continuum.step(state, dt));
          const auto values = continuum.bedding_values(state, continuum.slipping_planes()[0]);
          opened += !open && values.opening[0] > 0.;
          closed += open && values.opening[0] == 0.;
          open = values.opening[0] > 0.;
          // open: no traction; closed again: compression only, the tensile strength is lost
          const double most_tension = opened > 0 ? 0. : 2e4;
          EXPECT_GE(values.normal_stress[0], -most_tension - 1e-3);
          EXPECT_LE(open ? values.normal_stress[0] : 0., 1e-3);
        }
      EXPECT_GE(opened, 2);
      EXPECT_GE(closed, 1);
      EXPECT_NEAR(state.energy.bedding_loss, 60. * 2e4 * 2e4 / (2. * 1e9), 1e-6);
    }
}



// Broken in tension while it carries shear: the plane loses the elastic energy of both. Without
// friction it loses nothing else.
TEST(BeddingSlip, a_plane_that_breaks_loses_the_shear_stress_that_it_drops)
{
  auto scene                          = parameters(1e12);
  scene.continuum.degree              = 1; // two points per cell: 5 m each
  scene.bedding.friction_angle        = 0.;
  scene.bedding.tensile_strength      = 2e4;
  scene.bedding.initial_normal_stress = 1e5;
  scene.motion.angle                  = 45.;
  std::vector<double> a;
  for (int i = 0; i <= 200; ++i)
    a.push_back(30. * std::sin(0.1 * M_PI * i)); // 10 Hz
  Continuum    continuum(section(), scene, {scene::Motion(5e-3, a), scene.motion}, MPI_COMM_WORLD);
  const auto  &plane    = continuum.slipping_planes()[0];
  auto         state    = continuum.initial_state();
  double       expected = 0.;
  int          failed   = 0;
  const double length = 60. / 12., k_n = scene.bedding.normal_stiffness,
               k_s = scene.bedding.shear_stiffness;
  while (state.time < 0.4)
    {
      const auto before     = continuum.bedding_values(state, plane);
      const auto had_failed = state.slip.failed;
      ASSERT_EQ(before.slip.size(), 12u);
      ASSERT_TRUE(continuum.step(state, 1e-3));
      for (std::size_t i = 0; i < had_failed.size(); ++i)
        if (state.slip.failed[i] && !had_failed[i])
          {
            ++failed;
            expected += length * (2e4 * 2e4 / (2. * k_n) +
                                  before.shear_stress[i] * before.shear_stress[i] / (2. * k_s));
          }
    }
  EXPECT_GT(failed, 5);
  EXPECT_GT(expected, 10. * 60. * 2e4 * 2e4 / (2. * k_n)); // mostly of the shear stress
  EXPECT_NEAR(state.energy.bedding_loss, expected, 1e-6 * expected);
}
