// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/continuum.h>
#include <hybrid/scene/boundary/fixed_base.h>
#include <hybrid/scene/boundary/fixed_side.h>
#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/rigid_base.h>
#include <hybrid/scene/boundary/roller_side.h>

#include "rectangle_mesh.h"

#include <algorithm>
#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double time_step = 4e-3; ///< several stable ones [s]

  /// Rock under a motion and a load, with a plane.
  struct Scene
  {
    scene::SceneParameters parameters = test::rock_scene();
    scene::SectionMesh     section =
      test::rectangle_mesh(test::equal_spacing(0., 60., 6), test::equal_spacing(-30., 30., 5));

    Scene()
    {
      parameters.blocks.enabled        = false;
      parameters.continuum.degree      = 3;
      parameters.motion.angle          = 30.;
      parameters.bedding.names         = {"bedding_1"};
      parameters.point_loads.loads     = {{"push", Vec2(33., -3.), Vec2(1e6, -2e6)}};
      parameters.point_loads.frequency = 20.;
      section.lines["bedding_1"]       = {{14, 15}, {15, 16}, {16, 17}};
      set_scheme("fourth order");
    }

    void set_scheme(const std::string &name)
    {
      parameters.time.newmark = Newmark::preset(name);
      if (name == "fourth order")
        parameters.time.newmark.corrected_step = time_step;
    }

    void slant()
    {
      for (Vec2 &node : section.nodes)
        node += Vec2(0.1 * (node.y() + 30.), 0.05 * node.x() + 0.001 * node.x() * node.y());
    }

    std::unique_ptr<Continuum> make(const scene::LinearSolver solver)
    {
      std::vector<double> a;
      for (int i = 0; i < 100; ++i)
        a.push_back(3. * std::sin(0.4 * i) * std::exp(-0.02 * i));
      parameters.continuum.linear_solver = solver;
      return std::make_unique<Continuum>(section,
                                         parameters,
                                         scene::GroundMotion{{2e-3, a}, parameters.motion},
                                         MPI_COMM_SELF);
    }
  };



  /// Largest difference over the largest value of @p known, both of the model and its columns [-].
  double off(const std::vector<double> &found, const std::vector<double> &known)
  {
    EXPECT_EQ(found.size(), known.size());
    double difference = 0., largest = 0.;
    for (std::size_t i = 0; i < known.size(); ++i)
      {
        difference = std::max(difference, std::abs(found[i] - known[i]));
        largest    = std::max(largest, std::abs(known[i]));
      }
    EXPECT_GT(largest, 0.);
    return difference / largest;
  }



  void expect_equal_energy(const ContinuumEnergy &found, const ContinuumEnergy &known)
  {
    const double scale = std::abs(known.input_work) + known.kinetic + known.strain;
    EXPECT_NEAR(found.kinetic, known.kinetic, 1e-9 * scale);
    EXPECT_NEAR(found.strain, known.strain, 1e-9 * scale);
    EXPECT_NEAR(found.boundary_springs, known.boundary_springs, 1e-9 * scale);
    EXPECT_NEAR(found.input_work, known.input_work, 1e-9 * scale);
    EXPECT_NEAR(found.boundary_loss, known.boundary_loss, 1e-9 * scale);
    EXPECT_NEAR(found.damping_loss, known.damping_loss, 1e-9 * scale);
    EXPECT_NEAR(found.integration_loss, known.integration_loss, 1e-9 * scale);
  }



  void expect_equal_motion(Scene &scene, const std::string &what)
  {
    SCOPED_TRACE(what);
    const auto factor    = scene.make(scene::LinearSolver::factor),
               krylov    = scene.make(scene::LinearSolver::conjugate_gradients);
    ContinuumState known = factor->initial_state(), found = krylov->initial_state();
    for (int k = 0; k < 40; ++k)
      {
        const double dt = k < 30 ? time_step : 0.5 * time_step;
        ASSERT_TRUE(factor->step(known, dt));
        ASSERT_TRUE(krylov->step(found, dt));
      }
    EXPECT_NEAR(found.time, known.time, 1e-12);
    EXPECT_LT(off(found.displacement, known.displacement), 1e-9);
    EXPECT_LT(off(found.velocity, known.velocity), 1e-9);
    EXPECT_LT(off(found.acceleration, known.acceleration), 1e-9);
    krylov->collect(found, {});
    expect_equal_energy(krylov->audit_energy(found), factor->audit_energy(known));
  }



  TEST(ImplicitWaves, MoveAsTheFactoredSystemWithEveryBoundary)
  {
    using namespace scene;
    for (const auto &base : {compliant_base(), rigid_base(), fixed_base()})
      for (const auto &sides : {viscous_side(), free_field_side(), roller_side(), fixed_side()})
        {
          Scene scene;
          scene.parameters.continuum.base             = base;
          scene.parameters.continuum.sides            = sides;
          scene.parameters.continuum.boundary_springs = base.is_compliant;
          if (!sides.has_free_field)
            scene.slant();
          expect_equal_motion(scene, base.name + ' ' + sides.name);
        }
  }


  TEST(ImplicitWaves, MoveAsTheFactoredSystemWithEveryScheme)
  {
    for (const std::string name : {"dissipative", "filtered", "trapezoidal", "shi"})
      for (const auto &base : {scene::compliant_base(), scene::rigid_base()})
        {
          Scene scene;
          scene.set_scheme(name);
          scene.parameters.continuum.base  = base;
          scene.parameters.continuum.sides = scene::free_field_side();
          expect_equal_motion(scene, name + ' ' + base.name);
        }
  }


  TEST(ImplicitWaves, MoveAsTheFactoredSystemWithDamping)
  {
    for (const int damping : {1, 2, 3})
      for (const auto &base : {scene::compliant_base(), scene::rigid_base()})
        for (const std::string name : {"filtered", "fourth order"})
          {
            Scene scene;
            scene.set_scheme(name);
            scene.parameters.continuum.base  = base;
            scene.parameters.continuum.sides = scene::free_field_side();
            if (damping % 2 == 1)
              {
                scene.parameters.continuum.rayleigh_mass      = 0.5;
                scene.parameters.continuum.rayleigh_stiffness = 1e-4;
              }
            if (damping >= 2)
              scene.parameters.maxwell.bedrock_ratio = 0.05;
            expect_equal_motion(scene, std::to_string(damping) + ' ' + base.name + ' ' + name);
          }
  }
} // namespace
