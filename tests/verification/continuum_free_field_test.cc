// SPDX-License-Identifier: GPL-3.0-or-later
// A vertically incident wave in flat layered ground: with free-field sides the whole surface moves
// like the one-dimensional column, with viscous sides it visibly does not.
#include <gtest/gtest.h>

#include "continuum_check.h"
#include "rectangle_mesh.h"

#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/roller_side.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double width = 200., height = 100., dt = 1e-3;

  /// Two layers over the half space: 500 m/s above 60 m, 1000 m/s below.
  struct Ground
  {
    Ground(const scene::SideBoundary &sides, const double angle)
      : section(test::rectangle_mesh(test::equal_spacing(0., width, 20),
                                     test::equal_spacing(0., height, 10)))
      , scene(test::rock_scene())
    {
      for (std::size_t c = 0; c < section.bedrock_cells.size(); ++c)
        section.bedrock_region[c] = c / 20 >= 6 ? 1 : 0;
      section.bedrock_region_names = {"bedrock", "bedrock_upper"};
      auto upper                   = test::rock_material();
      upper.young_modulus *= 0.25;
      scene.materials["upper"]                         = upper;
      scene.continuum.region_material["bedrock_upper"] = "upper";
      scene.continuum.sides                            = sides;
      scene.continuum.rayleigh_mass                    = 0.4;
      scene.continuum.rayleigh_stiffness               = 1e-4;
      scene.motion.angle                               = angle;
    }

    /// Velocity histories of points along the surface.
    std::vector<std::vector<double>> run(const int component) const
    {
      Continuum continuum(section, scene, {test::ricker(6., dt), scene.motion}, MPI_COMM_WORLD);
      std::vector<Continuum::Point> points;
      for (const double x : {0., 3., 30., 100., 160., 200.})
        points.push_back(continuum.point({x, height}));
      auto                             state = continuum.initial_state();
      std::vector<std::vector<double>> result(points.size());
      for (int k = 0; k < 900; ++k)
        {
          continuum.step(state, dt);
          for (std::size_t i = 0; i < points.size(); ++i)
            result[i].push_back(continuum.sample(state, points[i]).velocity[component]);
        }
      return result;
    }

    scene::SectionMesh     section;
    scene::SceneParameters scene;
  };

  /// The one-dimensional solution: a bar between rollers turned to what is needed (see the joint
  /// test).
  std::vector<double> column_surface(const int component)
  {
    Ground ground(scene::roller_side(), 90.);
    if (component == 1)
      return ground.run(1)[3];

    // S: the same layers along x, motion along y.
    auto &mesh = ground.section;
    mesh =
      test::rectangle_mesh(test::equal_spacing(0., height, 10), test::equal_spacing(0., 20., 2));
    for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
      mesh.bedrock_region[c] = c % 10 >= 6 ? 1 : 0;
    mesh.bedrock_region_names = {"bedrock", "bedrock_upper"};
    const auto turned         = mesh.lines;
    mesh.lines["base"]        = turned.at("left");
    mesh.lines["ground"]      = turned.at("right");
    mesh.lines["left"]        = turned.at("base");
    mesh.lines["right"]       = turned.at("ground");
    Continuum           continuum(mesh,
                        ground.scene,
                        {test::ricker(6., dt), ground.scene.motion},
                        MPI_COMM_WORLD);
    const auto          point = continuum.point({height, 10.});
    auto                state = continuum.initial_state();
    std::vector<double> result;
    for (int k = 0; k < 900; ++k)
      {
        continuum.step(state, dt);
        result.push_back(continuum.sample(state, point).velocity.y());
      }
    return result;
  }

  /// Largest difference over the peak, worst point.
  double
  error(const scene::SideBoundary &sides, const int component, const std::vector<double> &expected)
  {
    double worst = 0.;
    for (const auto &history : Ground(sides, 90. * component).run(component))
      for (std::size_t k = 0; k < history.size(); ++k)
        worst = std::max(worst, std::abs(history[k] - expected[k]));
    return worst / test::largest(expected);
  }
} // namespace


TEST(FreeField, springs_follow_the_column)
{
  for (const int component : {0, 1})
    {
      Ground ground(scene::free_field_side(), 90. * component);
      ground.scene.continuum.boundary_springs = true;
      const auto expected                     = column_surface(component);
      double     worst                        = 0.;
      for (const auto &history : ground.run(component))
        for (std::size_t k = 0; k < history.size(); ++k)
          worst = std::max(worst, std::abs(history[k] - expected[k]));
      EXPECT_LT(worst / test::largest(expected), 1e-8);
    }
}


TEST(FreeField, surface_moves_like_the_column)
{
  for (const int component : {0, 1})
    {
      const auto expected = column_surface(component);
      EXPECT_LT(error(scene::free_field_side(), component, expected), 1e-8);
      EXPECT_GT(error(scene::viscous_side(), component, expected), 0.1);
    }
}
