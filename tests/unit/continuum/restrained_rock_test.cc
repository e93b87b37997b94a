// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/continuum.h>
#include <hybrid/continuum/restrained_rock.h>

#include "rectangle_mesh.h"

#include <algorithm>
#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  using Stresses = std::vector<std::array<double, 3>>;

  /// A valley of leaning cells with a plane to the ground and one that ends inside; soft rock
  /// above.
  struct Valley
  {
    scene::SceneParameters scene = test::rock_scene();
    scene::SectionMesh     section =
      test::rectangle_mesh(test::equal_spacing(0., 90., 9), test::equal_spacing(-40., 40., 5));

    explicit Valley(const int degree)
    {
      scene.blocks.enabled            = false;
      scene.continuum.degree          = degree;
      scene.materials["soft"]         = test::rock_material();
      scene.materials["soft"].density = 1800.;
      scene.materials["soft"].young_modulus *= 0.02;
      scene.continuum.region_material =
        scene::RegionMaterials::parse("bedrock: rock; bedrock_soft: soft");
      section.bedrock_region_names = {"bedrock", "bedrock_soft"};
      std::fill(section.bedrock_region.end() - 18, section.bedrock_region.end(), 1);
      section.lines["bedding_1"] = {{33, 34}, {34, 35}, {35, 36}, {36, 46}, {46, 56}};
      section.lines["bedding_2"] = {{22, 23}, {23, 24}};
      scene.bedding.names        = {"bedding_1", "bedding_2"};
      for (Vec2 &node : section.nodes)
        {
          const double up = (node.y() + 40.) / 40.;
          node += Vec2(0.05 * node.x() * (90. - node.x()) / 45. * up,
                       -8. * up * std::sin(3. * node.x() / 90.) + 0.06 * node.x());
        }
    }

    /// Static stress of the pictures.
    Stresses at_rest(const bool is_explicit)
    {
      scene.continuum.is_explicit = is_explicit;
      scene.time.newmark          = Newmark();
      if (is_explicit)
        scene.time.newmark.beta = 0.;
      Continuum        rock(section, scene, {}, MPI_COMM_SELF);
      const StaticSlip rest = rock.solve_static_state(Eigen::VectorXd(), 10., 1.5);
      EXPECT_TRUE(rest.solved);
      return rock.picture(rock.initial_state()).static_stress;
    }
  };



  double largest(const Stresses &stresses)
  {
    double result = 0.;
    for (const auto &stress : stresses)
      for (const double component : stress)
        result = std::max(result, std::abs(component));
    return result;
  }



  void expect_equal(const Stresses &found, const Stresses &known)
  {
    ASSERT_EQ(found.size(), known.size());
    double       off  = 0.;
    const double peak = largest(known);
    EXPECT_GT(peak, 1e5);
    for (std::size_t c = 0; c < known.size(); ++c)
      for (std::size_t k = 0; k < 3; ++k)
        off = std::max(off, std::abs(found[c][k] - known[c][k]));
    EXPECT_LT(off, 1e-11 * peak);
  }



  TEST(RestrainedRock, HasTheStressOfTheFactoredSystem)
  {
    for (const int degree : {1, 2, 3, 4, 5, 8})
      {
        Valley valley(degree);
        expect_equal(valley.at_rest(true), valley.at_rest(false));
      }
  }


  TEST(RestrainedRock, AddsToTheInitialStress)
  {
    Valley valley(3);
    valley.scene.environment.gravity             = 10.;
    valley.scene.environment.initial_stress      = "given";
    valley.scene.materials["rock"].initial_ratio = 0.8;
    valley.scene.materials["soft"].initial_ratio = 0.3;
    expect_equal(valley.at_rest(true), valley.at_rest(false));
  }


  /// A square of n x n cells under a load, with a level plane.
  RestrainedRock::Solution
  square_at_rest(const int n, const int degree, const JointStiffness &joints, const bool is_held)
  {
    scene::SectionMesh section =
      test::rectangle_mesh(test::equal_spacing(0., 100., n), test::equal_spacing(0., 100., n));
    for (int i = 0; i < n; ++i)
      section.lines["bedding_1"].push_back({n / 2 * (n + 1) + i, n / 2 * (n + 1) + i + 1});
    const RockMesh rock = split_bedding_planes(section, {"bedding_1"});
    ElementSpace   space(rock, section, degree, MPI_COMM_SELF, MassQuadrature::lobatto);
    const std::vector<Material> material(rock.cells.size(), test::rock_material());
    const SharedRock            shared(space, MPI_COMM_SELF);
    std::vector<char>           supported;
    std::vector<double>         load;
    for (const Vec2 &at : space.nodes.positions)
      for (int c = 0; c < 2; ++c)
        {
          supported.push_back(is_held &&
                              (at.y() == 0. || (c == 0 && (at.x() == 0. || at.x() == 100.))));
          load.push_back(c == 0 ? at.y() : -1. - at.x());
        }
    return RestrainedRock({shared, rock, space.nodes, material, joints, supported}).solve(load);
  }


  int iterations(const int n, const int degree, const JointStiffness &joints)
  {
    const auto found = square_at_rest(n, degree, joints, true);
    EXPECT_TRUE(found.converged);
    return found.iterations;
  }


  TEST(RestrainedRock, IterationsHardlyGrowWithTheMesh)
  {
    for (const int degree : {2, 4, 6})
      {
        const int coarse = iterations(8, degree, {1e9, 3e8}),
                  fine   = iterations(32, degree, {1e9, 3e8});
        EXPECT_LE(fine, coarse + 10) << degree;
        EXPECT_LE(fine, 30) << degree;
      }
    EXPECT_LE(iterations(16, 3, {1e12, 1e11}), 100); // planes as stiff as 100 m of rock
  }


  TEST(RestrainedRock, SaysThatNothingHoldsTheRock)
  {
    EXPECT_FALSE(square_at_rest(4, 2, {1e9, 3e8}, false).converged);
  }
} // namespace
