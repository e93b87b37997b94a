// SPDX-License-Identifier: GPL-3.0-or-later
// Level ground with horizontal bedding planes from side to side under a wave from below: with the
// planes' joints in the free-field columns it stays one-dimensional, however narrow the section is.
#include <gtest/gtest.h>

#include "continuum_check.h"
#include "rectangle_mesh.h"

#include <hybrid/restart/archive.h>
#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/rigid_base.h>
#include <hybrid/scene/boundary/roller_side.h>

#include <string>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double height = 100., dt = 1e-3, seconds = 0.7;
  constexpr int    rows = 10, plane_row = 6, deep_row = 3;

  /// 500 m/s above the upper plane, 1000 m/s below.
  scene::SectionMesh layers(scene::SectionMesh mesh, const int columns, const bool along_x)
  {
    for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
      mesh.bedrock_region[c] = (along_x ? c % rows : c / columns) >= plane_row ? 1 : 0;
    mesh.bedrock_region_names = {"bedrock", "bedrock_upper"};
    return mesh;
  }

  /// @param slope of the planes, by which all but base and ground is bent [-]
  scene::SectionMesh level_ground(const double width, const double slope = 0.)
  {
    const int columns = static_cast<int>(width / 10.);
    auto      mesh    = layers(test::rectangle_mesh(test::equal_spacing(0., width, columns),
                                            test::equal_spacing(0., height, rows)),
                       columns,
                       false);
    for (Vec2 &node : mesh.nodes)
      node.y() +=
        slope * (node.x() - 0.5 * width) * 4. * node.y() / height * (1. - node.y() / height);
    for (int i = 0; i < columns; ++i)
      for (const auto &[name, row] : {std::pair{"bedding_1", plane_row}, {"bedding_2", deep_row}})
        mesh.lines[name].push_back({row * (columns + 1) + i, row * (columns + 1) + i + 1});
    return mesh;
  }

  /// The same layers along x: between rollers an S wave (motion along y) stays in one dimension.
  scene::SectionMesh lying_ground()
  {
    auto mesh = layers(test::rectangle_mesh(test::equal_spacing(0., height, rows),
                                            test::equal_spacing(0., 20., 2)),
                       rows,
                       true);
    for (int i = 0; i < 2; ++i)
      for (const auto &[name, row] : {std::pair{"bedding_1", plane_row}, {"bedding_2", deep_row}})
        mesh.lines[name].push_back({i * (rows + 1) + row, (i + 1) * (rows + 1) + row});
    const auto turned    = mesh.lines;
    mesh.lines["base"]   = turned.at("left");
    mesh.lines["ground"] = turned.at("right");
    mesh.lines["left"]   = turned.at("base");
    mesh.lines["right"]  = turned.at("ground");
    return mesh;
  }

  scene::SceneParameters parameters(const int component)
  {
    auto scene = test::rock_scene();
    auto upper = test::rock_material();
    upper.young_modulus *= 0.25;
    scene.materials["upper"]                         = upper;
    scene.continuum.region_material["bedrock_upper"] = "upper";
    scene.continuum.sides                            = scene::free_field_side();
    scene.motion.angle                               = 90. * component;
    scene.environment.gravity                        = 0.;
    scene.bedding.names                              = {"bedding_1", "bedding_2"};
    scene.bedding.normal_stiffness                   = 4e8;
    scene.bedding.shear_stiffness                    = 1e8;
    return scene;
  }

  /// Strength that the wave exceeds about sevenfold, and opens the plane.
  void weaken(scene::BeddingParameters &bedding)
  {
    bedding.slips                 = true;
    bedding.friction_angle        = 20.;
    bedding.cohesion              = 2e3;
    bedding.tensile_strength      = 1e3;
    bedding.initial_normal_stress = 1e4;
  }

  struct Result
  {
    std::vector<std::vector<double>> top; ///< velocity along the wave's motion
    ContinuumEnergy                  energy;
  };

  Result run(const scene::SectionMesh     &mesh,
             const scene::SceneParameters &scene,
             const std::vector<Vec2>      &places,
             const int                     component)
  {
    Continuum continuum(mesh, scene, {test::ricker(6., dt), scene.motion}, MPI_COMM_WORLD);
    std::vector<Continuum::Point> points;
    for (const Vec2 &place : places)
      points.push_back(continuum.point(place));
    continuum.watch(points);
    const double gravity = scene.environment.gravity;
    EXPECT_TRUE(gravity == 0. ||
                continuum.solve_static_state(Eigen::VectorXd(), gravity).equilibrium);
    auto   state = continuum.initial_state();
    Result result;
    result.top.resize(points.size());
    for (int k = 0; k * dt < seconds; ++k)
      {
        EXPECT_TRUE(continuum.step(state, dt));
        for (std::size_t i = 0; i < points.size(); ++i)
          result.top[i].push_back(continuum.sample(state, points[i]).velocity[component]);
      }
    continuum.collect(state, true);
    result.energy = continuum.audit_energy(state);
    return result;
  }

  Result box(const scene::SceneParameters &scene, const int component, const double width = 20.)
  {
    std::vector<Vec2> places;
    for (const double part : {0., 0.15, 0.5, 0.85, 1.})
      places.emplace_back(part * width, height);
    return run(level_ground(width), scene, places, component);
  }

  Result column(scene::SceneParameters scene, const int component)
  {
    scene.continuum.sides = scene::roller_side();
    scene.motion.angle    = 90.;
    return component == 0 ? run(lying_ground(), scene, {{height, 10.}}, 1)
                          : run(level_ground(20.), scene, {{10., height}}, 1);
  }

  /// Largest difference of the histories over the peak.
  double error(const Result &found, const Result &expected)
  {
    double worst = 0.;
    for (const auto &history : found.top)
      for (std::size_t k = 0; k < history.size(); ++k)
        worst = std::max(worst, std::abs(history[k] - expected.top[0][k]));
    return worst / test::largest(expected.top[0]);
  }

  double residual(const ContinuumEnergy &e)
  {
    const double sum = e.kinetic + e.strain + e.bedding_static_stress - e.input_work +
                       e.boundary_loss + e.damping_loss + e.bedding_loss + e.integration_loss;
    return std::abs(sum) / std::abs(e.input_work);
  }
} // namespace


TEST(ColumnPlanes, elastic_planes_leave_level_ground_in_one_dimension)
{
  for (const int component : {0, 1})
    {
      auto       scene    = parameters(component);
      const auto expected = column(scene, component);
      EXPECT_LT(error(box(scene, component), expected), 1e-8) << component;
      scene.bedding.names.clear();
      EXPECT_GT(error(box(scene, component), expected), 0.1) << component; // the joint counts
    }
}


TEST(ColumnPlanes, so_do_elastic_planes_in_rock_that_damps)
{
  for (const int component : {0, 1})
    {
      auto scene                         = parameters(component);
      scene.continuum.rayleigh_mass      = 0.4;
      scene.continuum.rayleigh_stiffness = 1e-4;
      scene.maxwell.bedrock_ratio        = 0.05;
      scene.time.newmark                 = Newmark::preset("filtered");
      EXPECT_LT(error(box(scene, component), column(scene, component)), 1e-8) << component;
    }
}


TEST(ColumnPlanes, planes_that_slip_or_open_leave_it_in_one_dimension)
{
  for (const int component : {0, 1})
    {
      auto scene = parameters(component);
      weaken(scene.bedding);
      scene.continuum.rayleigh_stiffness = 1e-4;
      scene.time.newmark                 = Newmark::preset("filtered");
      const auto expected                = column(scene, component);
      const auto found                   = box(scene, component);
      EXPECT_LT(error(found, expected), 1e-8) << component;
      EXPECT_LT(residual(found.energy), 1e-9) << component;
      EXPECT_GT(found.energy.bedding_loss, component == 0 ? 1e-3 * found.energy.input_work : 0.);
      scene.bedding.slips = false;
      EXPECT_GT(error(box(scene, component), expected), 0.1) << component; // the strength counts
    }
}


TEST(ColumnPlanes, so_they_do_on_a_rigid_base)
{
  auto scene = parameters(0);
  weaken(scene.bedding);
  scene.continuum.base = scene::rigid_base();
  EXPECT_LT(error(box(scene, 0), column(scene, 0)), 1e-8);
}


TEST(ColumnPlanes, so_does_a_wide_section_and_one_under_its_own_weight)
{
  auto scene = parameters(0);
  weaken(scene.bedding);
  const auto expected = column(scene, 0);
  EXPECT_LT(error(box(scene, 0, 200.), expected), 1e-8);

  // 40 m of rock weigh 10 kPa on the upper plane, 70 m 17.5 kPa on the lower one.
  scene.environment.gravity           = 0.125;
  scene.bedding.initial_normal_stress = 0.;
  const auto narrow = box(scene, 0), wide = box(scene, 0, 200.);
  EXPECT_LT(error(narrow, wide), 1e-8);
  EXPECT_LT(residual(narrow.energy), 1e-9);
  EXPECT_GT(error(narrow, expected), 1e-3); // the lower plane slips less
}


TEST(ColumnPlanes, steps_without_a_matrix_have_them_as_well)
{
  for (const int component : {0, 1})
    for (const bool is_explicit : {false, true})
      {
        auto scene                         = parameters(component);
        scene.continuum.is_explicit        = is_explicit;
        scene.continuum.linear_solver      = scene::LinearSolver::conjugate_gradients;
        scene.continuum.rayleigh_mass      = 0.4;
        scene.continuum.rayleigh_stiffness = 1e-4;
        scene.maxwell.bedrock_ratio        = 0.05;
        scene.time.newmark                 = Newmark::preset("trapezoidal");
        if (is_explicit)
          scene.time.newmark.beta = 0.;
        EXPECT_LT(error(box(scene, component), column(scene, component)), 1e-8)
          << component << is_explicit;
      }
}


TEST(ColumnPlanes, inclined_planes_move_like_their_mirror_image)
{
  const std::vector<Vec2> places = {{0., height}, {5., height}, {35., height}, {40., height}};
  auto                    scene  = parameters(0);
  weaken(scene.bedding);
  scene.environment.gravity = 0.125;
  const auto one            = run(level_ground(40., 0.2), scene, places, 0);
  scene.motion.angle        = 180.;
  const auto other          = run(level_ground(40., -0.2), scene, places, 0);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < one.top[i].size(); ++k)
      ASSERT_NEAR(one.top[i][k], -other.top[3 - i][k], 1e-9 * test::largest(one.top[i])) << k;
  EXPECT_LT(residual(one.energy), 1e-9);
  EXPECT_GT(one.energy.bedding_loss, 1e-3 * one.energy.input_work);
}


TEST(ColumnPlanes, a_state_that_was_kept_goes_on_to_the_same_bits)
{
  auto scene = parameters(0);
  weaken(scene.bedding);
  const auto                mesh = level_ground(20.);
  const scene::GroundMotion motion(test::ricker(6., dt), scene.motion);
  Continuum                 one(mesh, scene, motion, MPI_COMM_WORLD);
  auto                      state = one.initial_state();
  const auto                steps = [&state](Continuum &continuum, const int count) {
    for (int k = 0; k < count; ++k)
      EXPECT_TRUE(continuum.step(state, dt));
  };
  steps(one, 350);
  const std::vector<double> slipped = state.column_slip[0].jump;
  EXPECT_GT(std::abs(slipped[1]), 1e-5);
  auto writer = restart::Archive::writer();
  writer(state);
  steps(one, 200);
  const auto expected = state;
  EXPECT_NE(expected.column_slip[0].jump, slipped);

  Continuum other(mesh, scene, motion, MPI_COMM_WORLD);
  state       = other.initial_state();
  auto reader = restart::Archive::reader(writer.content());
  reader(state);
  steps(other, 200);
  EXPECT_EQ(state.displacement, expected.displacement);
  EXPECT_EQ(state.column_slip[0].jump, expected.column_slip[0].jump);
}


TEST(ColumnPlanes, planes_that_meet_at_a_side_are_welded_in_its_column)
{
  // A lens between the planes, from side to side.
  scene::SectionMesh mesh;
  mesh.nodes          = {{0., 0.},
                         {10., 0.},
                         {20., 0.},
                         {0., 50.},
                         {10., 45.},
                         {20., 50.},
                         {10., 55.},
                         {0., 100.},
                         {10., 100.},
                         {20., 100.}};
  mesh.bedrock_cells  = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 5, 6}, {3, 6, 8, 7}, {6, 5, 9, 8}};
  mesh.bedrock_region = {0, 0, 0, 0, 0};
  mesh.bedrock_region_names = {"bedrock"};
  mesh.lines["base"]        = {{0, 1}, {1, 2}};
  mesh.lines["left"]        = {{0, 3}, {3, 7}};
  mesh.lines["right"]       = {{2, 5}, {5, 9}};
  mesh.lines["ground"]      = {{7, 8}, {8, 9}};
  mesh.lines["bedding_1"]   = {{3, 4}, {4, 5}};
  mesh.lines["bedding_2"]   = {{3, 6}, {6, 5}};
  auto scene                = parameters(0);
  weaken(scene.bedding);
  for (const int planes : {1, 2})
    {
      scene.bedding.names = {"bedding_1", "bedding_2"};
      scene.bedding.names.resize(planes);
      Continuum  continuum(mesh, scene, {test::ricker(6., dt), scene.motion}, MPI_COMM_WORLD);
      auto       state   = continuum.initial_state();
      const auto columns = state.displacement.size() - continuum.n_unknowns();
      EXPECT_EQ(columns, planes == 1 ? 2u * 2u * 6u : 2u * 2u * 5u);
      EXPECT_EQ(state.column_slip.size(), planes == 1 ? 2u : 0u);
      for (int k = 0; k < 300; ++k)
        ASSERT_TRUE(continuum.step(state, dt));
    }
}
