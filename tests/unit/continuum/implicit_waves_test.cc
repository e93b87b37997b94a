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



  /// Of a motion that should be the same: the largest difference and the largest value.
  struct Difference
  {
    double difference = 0., peak = 0.;

    void add(const std::vector<double> &found, const std::vector<double> &known)
    {
      ASSERT_EQ(found.size(), known.size());
      for (std::size_t i = 0; i < known.size(); ++i)
        {
          difference = std::max(difference, std::abs(found[i] - known[i]));
          peak       = std::max(peak, std::abs(known[i]));
        }
    }
  };



  void expect_equal_energy(const ContinuumEnergy &found, const ContinuumEnergy &known)
  {
    const double scale =
      std::abs(known.input_work) + known.kinetic + known.strain + known.boundary_loss;
    EXPECT_NEAR(found.kinetic, known.kinetic, 1e-9 * scale);
    EXPECT_NEAR(found.strain, known.strain, 1e-9 * scale);
    EXPECT_NEAR(found.boundary_springs, known.boundary_springs, 1e-9 * scale);
    EXPECT_NEAR(found.input_work, known.input_work, 1e-9 * scale);
    EXPECT_NEAR(found.boundary_loss, known.boundary_loss, 1e-9 * scale);
    EXPECT_NEAR(found.damping_loss, known.damping_loss, 1e-9 * scale);
    EXPECT_NEAR(found.integration_loss, known.integration_loss, 1e-9 * scale);
  }



  void expect_equal_motion(Scene &scene, const std::string &what, const double tolerance = 1e-9)
  {
    SCOPED_TRACE(what);
    const auto factor    = scene.make(scene::LinearSolver::factor),
               krylov    = scene.make(scene::LinearSolver::conjugate_gradients);
    ContinuumState known = factor->initial_state(), found = krylov->initial_state();
    factor->start_wave(known);
    krylov->start_wave(found);
    Difference displacement, velocity, acceleration; // of the model and its columns
    for (int k = 0; k < 40; ++k)
      {
        const double dt = k < 30 ? time_step : 0.5 * time_step;
        ASSERT_TRUE(factor->step(known, dt));
        ASSERT_TRUE(krylov->step(found, dt));
        displacement.add(found.displacement, known.displacement);
        velocity.add(found.velocity, known.velocity);
        acceleration.add(found.acceleration, known.acceleration);
      }
    EXPECT_TRUE(krylov->is_iterated());
    EXPECT_EQ(krylov->factor_time(), 0.);
    EXPECT_FALSE(factor->is_iterated());
    EXPECT_NEAR(found.time, known.time, 1e-12);
    for (const Difference &of : {displacement, velocity, acceleration})
      {
        EXPECT_GT(of.peak, 0.);
        EXPECT_LT(of.difference, tolerance * of.peak);
      }
    krylov->collect(found, true);
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


  // It begins on the boundary, where the fourth order makes it ring by 30,000 g: no step takes that
  // away.
  TEST(ImplicitWaves, BeginAsTheFactoredSystemWithAWave)
  {
    for (const std::string name : {"filtered", "fourth order"})
      for (const double damping : {0., 0.05})
        for (const auto &base : {scene::compliant_base(), scene::rigid_base()})
          {
            Scene scene;
            scene.set_scheme(name);
            scene.parameters.continuum.base             = base;
            scene.parameters.continuum.boundary_springs = base.is_compliant;
            scene.parameters.continuum.rayleigh_mass    = 10. * damping;
            scene.parameters.maxwell.bedrock_ratio      = damping;
            scene.parameters.initial_wave.type          = scene::WaveType::shear;
            scene.parameters.initial_wave.direction     = -60.;
            scene.parameters.initial_wave.centre        = Vec2(30., -15.);
            scene.parameters.initial_wave.width         = 1.;
            scene.parameters.initial_wave.frequency     = 50.;
            expect_equal_motion(scene,
                                base.name + ' ' + std::to_string(damping) + ' ' + name,
                                1e-8);
          }
  }


  TEST(ImplicitWaves, GoOnFromACopyWithTheSameBits)
  {
    Scene scene;
    scene.set_scheme("filtered");
    scene.parameters.continuum.sides       = scene::free_field_side();
    scene.parameters.maxwell.bedrock_ratio = 0.02;
    const auto     rock                    = scene.make(scene::LinearSolver::conjugate_gradients);
    ContinuumState state                   = rock->initial_state();
    const auto     go_on                   = [&](Continuum &with) {
      for (int k = 0; k < 10; ++k)
        ASSERT_TRUE(with.step(state, time_step));
    };
    go_on(*rock);
    const ContinuumState copy = state;
    go_on(*rock);
    const ContinuumState first = state;
    state                      = copy;
    rock->collect(state, true); // output changes no state
    const auto resumed = scene.make(scene::LinearSolver::conjugate_gradients);
    go_on(*resumed);
    EXPECT_EQ(state.displacement, first.displacement);
    EXPECT_EQ(state.velocity, first.velocity);
    EXPECT_EQ(state.acceleration, first.acceleration);
    EXPECT_EQ(state.acceleration_change, first.acceleration_change);
    EXPECT_EQ(state.maxwell.strain, first.maxwell.strain);
    EXPECT_EQ(state.energy.input_work, first.energy.input_work);
  }
} // namespace
