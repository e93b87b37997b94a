// SPDX-License-Identifier: GPL-3.0-or-later
// Level ground with a horizontal bedding plane from side to side under a wave from below: with the
// plane's joint in the free-field columns it stays one-dimensional, however narrow the section is.
#include <gtest/gtest.h>

#include "continuum_check.h"
#include "rectangle_mesh.h"

#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/roller_side.h>

#include <string>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double height = 100., plane_at = 60., dt = 1e-3, seconds = 0.7;
  constexpr int    rows = 10, plane_row = 6;

  /// 500 m/s above the plane, 1000 m/s below.
  scene::SectionMesh layers(scene::SectionMesh mesh, const int columns, const bool along_x)
  {
    for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
      mesh.bedrock_region[c] = (along_x ? c % rows : c / columns) >= plane_row ? 1 : 0;
    mesh.bedrock_region_names = {"bedrock", "bedrock_upper"};
    return mesh;
  }

  scene::SectionMesh level_ground(const double width)
  {
    const int columns = static_cast<int>(width / 10.);
    auto      mesh    = layers(test::rectangle_mesh(test::equal_spacing(0., width, columns),
                                            test::equal_spacing(0., height, rows)),
                       columns,
                       false);
    for (int i = 0; i < columns; ++i)
      mesh.lines["bedding_1"].push_back(
        {plane_row * (columns + 1) + i, plane_row * (columns + 1) + i + 1});
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
      mesh.lines["bedding_1"].push_back(
        {i * (rows + 1) + plane_row, (i + 1) * (rows + 1) + plane_row});
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
    scene.bedding.names                              = {"bedding_1"};
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
    std::vector<std::vector<double>> top;  ///< velocity along the wave's motion
    std::vector<double>              slip; ///< at the end, of all points [m]
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
    auto   state = continuum.initial_state();
    Result result;
    result.top.resize(points.size());
    for (int k = 0; k * dt < seconds; ++k)
      {
        EXPECT_TRUE(continuum.step(state, dt));
        for (std::size_t i = 0; i < points.size(); ++i)
          result.top[i].push_back(continuum.sample(state, points[i]).velocity[component]);
      }
    for (const auto &plane : continuum.slipping_planes())
      {
        const auto  values = continuum.bedding_values(state, plane);
        const auto &moved =
          component == 0 || mesh.lines.at("base").front()[1] > 1 ? values.slip : values.opening;
        result.slip.insert(result.slip.end(), moved.begin(), moved.end());
      }
    continuum.collect(state, {});
    result.energy = continuum.audit_energy(state);
    return result;
  }

  /// Narrow level ground, mirror images of places among those asked for.
  Result box(const scene::SceneParameters &scene, const int component, const double width = 20.)
  {
    return run(
      level_ground(width),
      scene,
      {{0., height}, {3., height}, {0.5 * width, height}, {width - 3., height}, {width, height}},
      component);
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
