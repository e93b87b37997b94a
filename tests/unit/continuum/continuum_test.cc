// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/continuum.h>
#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/rigid_base.h>
#include <hybrid/scene/input_error.h>

#include "rectangle_mesh.h"

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  scene::SectionMesh box()
  {
    return test::rectangle_mesh(test::equal_spacing(0., 40., 4), test::equal_spacing(-30., 30., 3));
  }
} // namespace


TEST(Continuum, gravity_stress_grows_with_depth)
{
  for (const bool jointed : {false, true})
    {
      auto section               = box();
      auto scene                 = test::rock_scene();
      section.lines["bedding_1"] = {{5, 6}, {6, 7}, {7, 8}, {8, 9}};
      if (jointed)
        scene.bedding.names = {"bedding_1"};
      Continuum continuum(section, scene, {}, MPI_COMM_WORLD);
      continuum.solve_static_state(Eigen::VectorXd(), 10.);
      const auto picture = continuum.picture(continuum.initial_state());
      ASSERT_EQ(picture.cells.size(), 48u);
      for (std::size_t c = 0; c < picture.cells.size(); ++c)
        {
          Vec2 centre(0., 0.);
          for (const int p : picture.cells[c])
            centre += 0.25 * picture.points[p];
          const double vertical = 2000. * 10. * centre.y();
          EXPECT_NEAR(picture.static_stress[c][1], vertical, 1e-6 * 6e5);
          EXPECT_NEAR(picture.static_stress[c][0], vertical / 3., 1e-6 * 6e5); // nu / (1 - nu)
          EXPECT_NEAR(picture.static_stress[c][2], 0., 1e-6 * 6e5);
          EXPECT_EQ(picture.stress[c][1], 0.);
        }
    }
}


TEST(Continuum, surface_force_is_carried_by_the_base)
{
  auto section = box();
  test::add_block(section);
  Continuum continuum(section, test::rock_scene(), {}, MPI_COMM_WORLD);
  // A uniform pressure of 1 MPa: consistent nodal forces of degree 2 are h (1/6, 4/6, 1/6).
  Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * 9);
  for (int e = 0; e < 4; ++e)
    for (int i = 0; i < 3; ++i)
      force[2 * (2 * e + i) + 1] -= 1e6 * 10. * (i == 1 ? 4. : 1.) / 6.;
  continuum.solve_static_state(force, 0.);
  for (const auto &stress : continuum.picture(continuum.initial_state()).static_stress)
    EXPECT_NEAR(stress[1], -1e6, 1e-3);
}


TEST(Continuum, samples_and_points)
{
  Continuum  continuum(box(), test::rock_scene(), {}, MPI_COMM_WORLD);
  auto       state  = continuum.initial_state();
  const auto points = continuum.picture(state).points;
  for (std::size_t k = 0; k < points.size(); ++k)
    {
      state.displacement[2 * k] = points[k].x() * points[k].y(); // in the space of degree 2
      state.velocity[2 * k + 1] = points[k].y() * points[k].y();
    }
  const Vec2 p(13.3, -7.7);
  const auto inside = continuum.point(p);
  const auto edge   = continuum.point({20., 0.3});
  EXPECT_NEAR(continuum.sample(state, inside).displacement.x(), p.x() * p.y(), 1e-10);
  EXPECT_NEAR(continuum.sample(state, inside).velocity.y(), p.y() * p.y(), 1e-10);
  EXPECT_NEAR(continuum.sample(state, edge).displacement.x(), 0., 1e-10);
  EXPECT_NEAR(inside.outside, 0., 1e-12);
  EXPECT_NEAR(edge.outside, 0.3, 1e-12);
  EXPECT_TRUE(std::isinf(continuum.point({20., 50.}).outside));
  EXPECT_NEAR(continuum.point({20., 50.}, 60.).outside, 50., 1e-9);
}


TEST(Continuum, resolution_counts_nodes_per_wave_length)
{
  const Continuum continuum(box(), test::rock_scene(), {}, MPI_COMM_WORLD);
  const auto      r = continuum.resolution();
  EXPECT_EQ(r.cells, 12);
  EXPECT_NEAR(r.slowest_s_wave, 1000., 1e-9);
  EXPECT_NEAR(r.fastest_p_wave, 1000. * std::sqrt(3.), 1e-9);
  EXPECT_NEAR(r.highest_frequency, 1000. / (10. * 5.), 1e-9);
  EXPECT_EQ(r.surface_unknowns, 0u);
}


TEST(Continuum, what_the_corrected_inertia_leaves_hangs_on_the_way_between_nodes)
{
  const Continuum continuum(box(), test::rock_scene(), {}, MPI_COMM_WORLD);
  const double    way = 1. / continuum.resolution().highest_frequency / 10.; // cells are squares
  EXPECT_NEAR(continuum.uncorrected_part(way, false), 1. / 3., 1e-6);        // q = 1/2
  EXPECT_NEAR(continuum.uncorrected_part(way, true), 4.5 / 5.5, 1e-6);       // q = 9/2
  EXPECT_LT(continuum.uncorrected_part(0.1 * way, false), 1e-4);
  EXPECT_GT(continuum.uncorrected_part(10. * way, false), 0.999);
}


TEST(Continuum, mistakes_are_refused)
{
  const auto make = [](const scene::SectionMesh &mesh, const scene::SceneParameters &scene) {
    Continuum continuum(mesh, scene, {}, MPI_COMM_WORLD);
  };
  auto no_base = box();
  no_base.lines.erase("base");
  EXPECT_THROW(make(no_base, test::rock_scene()), InputError);

  auto wrong_foundation = box();
  wrong_foundation.lines["base"].push_back({5, 6});
  EXPECT_THROW(make(wrong_foundation, test::rock_scene()), InputError);

  auto no_material                      = test::rock_scene();
  no_material.continuum.region_material = {};
  EXPECT_THROW(make(box(), no_material), InputError);

  auto unknown_material                           = test::rock_scene();
  unknown_material.continuum.region_material["*"] = "cheese";
  EXPECT_THROW(make(box(), unknown_material), InputError);

  auto inclined = box();
  inclined.nodes[4].x() += 1.;
  auto free_field            = test::rock_scene();
  free_field.continuum.sides = scene::free_field_side();
  EXPECT_THROW(make(inclined, free_field), InputError);
}


TEST(Continuum, rigid_base_moves_as_prescribed)
{
  std::vector<double> a;
  for (int i = 0; i <= 200; ++i)
    a.push_back(2. * std::sin(0.05 * i));
  const scene::Motion motion(1e-3, a);
  for (const char *scheme : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      auto scene           = test::rock_scene();
      scene.continuum.base = scene::rigid_base();
      scene.motion.angle   = 90.;
      scene.time.newmark   = Newmark::preset(scheme);
      Continuum  continuum(box(), scene, {motion, scene.motion}, MPI_COMM_WORLD);
      const auto base  = continuum.point({20., -30.});
      auto       state = continuum.initial_state();
      for (int k = 0; k < 150; ++k)
        continuum.step(state, 1e-3);
      const auto s = continuum.sample(state, base);
      EXPECT_NEAR(s.acceleration.y(), motion.acceleration(state.time), 1e-9);
      EXPECT_NEAR(s.velocity.y(), motion.velocity(state.time), 2e-3 * 2.);
      EXPECT_NEAR(s.displacement.y() / motion.displacement(state.time), 1., 0.02);
      EXPECT_NEAR(s.displacement.x(), 0., 1e-12);
    }
}
