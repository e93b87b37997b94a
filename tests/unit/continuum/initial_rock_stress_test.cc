// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/continuum.h>

#include "rectangle_mesh.h"

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double weight = 2000. * 10.; // of the rock [N/m3]

  /// Rock from y = -40 m to the ground at 0; bedding_1 is level at -20 m, bedding_2 upright from
  /// there to the ground.
  scene::SectionMesh section()
  {
    auto mesh =
      test::rectangle_mesh(test::equal_spacing(0., 40., 4), test::equal_spacing(-40., 40., 4));
    mesh.lines["bedding_1"] = {{10, 11}, {11, 12}, {12, 13}, {13, 14}};
    mesh.lines["bedding_2"] = {{12, 17}, {17, 22}};
    return mesh;
  }

  scene::SceneParameters parameters(const double ratio)
  {
    auto scene                            = test::rock_scene();
    scene.blocks.enabled                  = false;
    scene.environment.gravity             = 10.;
    scene.environment.initial_stress      = "given";
    scene.materials["rock"].initial_ratio = ratio;
    scene.bedding.names                   = {"bedding_1", "bedding_2"};
    return scene;
  }

  void make_weak(scene::SceneParameters &scene)
  {
    scene.bedding.slips          = true;
    scene.bedding.friction_angle = 30.;
  }
} // namespace



TEST(InitialRockStress, level_ground_has_the_given_ratio_and_its_planes_bear_it)
{
  for (const int degree : {1, 2, 3})
    for (const double ratio : {0., 0.4, 1.5})
      for (const bool slips : {false, true})
        {
          auto scene             = parameters(ratio);
          scene.continuum.degree = degree;
          if (slips)
            make_weak(scene);
          Continuum  rock(section(), scene, {}, MPI_COMM_WORLD);
          const auto rest = rock.solve_static_state(Eigen::VectorXd(), 10.);
          EXPECT_TRUE(rest.equilibrium);
          EXPECT_LT(rest.largest, 1e-12);
          const auto state   = rock.initial_state();
          const auto picture = rock.picture(state);
          for (std::size_t c = 0; c < picture.cells.size(); ++c)
            {
              double height = 0.;
              for (const int p : picture.cells[c])
                height += 0.25 * picture.points[p].y();
              EXPECT_NEAR(picture.static_stress[c][1], weight * height, 1e-9 * weight * 40.);
              EXPECT_NEAR(picture.static_stress[c][0],
                          ratio * weight * height,
                          1e-9 * weight * 40.);
              EXPECT_NEAR(picture.static_stress[c][2], 0., 1e-9 * weight * 40.);
            }
          for (const BeddingPlane &plane : rock.slipping_planes())
            {
              const auto   values = rock.bedding_values(state, plane);
              const double part   = plane.name == "bedding_1" ? 1. : ratio;
              for (std::size_t i = 0; i < plane.points.size(); ++i)
                {
                  const double depth = -plane.points[i].y();
                  EXPECT_NEAR(values.normal_stress[i], part * weight * depth, 1e-9 * weight * 40.);
                  EXPECT_NEAR(values.shear_stress[i], 0., 1e-9 * weight * 40.);
                }
            }
        }
}



TEST(InitialRockStress, the_ratio_of_elasticity_is_gravity_switched_on)
{
  auto mesh = section();
  mesh.lines.erase("bedding_2");
  auto given                         = parameters(-1.);
  given.bedding.names                = {"bedding_1"};
  auto elastic                       = given;
  elastic.environment.initial_stress = "elastic";
  for (const double push : {0., 1e6})
    {
      Continuum one(mesh, given, {}, MPI_COMM_WORLD), other(mesh, elastic, {}, MPI_COMM_WORLD);
      one.solve_static_state(Eigen::VectorXd(), 10., push / weight);
      other.solve_static_state(Eigen::VectorXd(), 10., push / weight);
      const auto found = one.picture(one.initial_state()).static_stress;
      const auto known = other.picture(other.initial_state()).static_stress;
      for (std::size_t c = 0; c < found.size(); ++c)
        for (int k = 0; k < 3; ++k)
          EXPECT_NEAR(found[c][k], known[c][k], 1e-9 * std::max(weight * 40., push));
    }
}
