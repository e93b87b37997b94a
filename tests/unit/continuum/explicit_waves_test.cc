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

  /// Explicit steps of rock with a slanting base and side, so that dashpots couple x and y.
  struct Waves
  {
    scene::SceneParameters scene = test::rock_scene();
    scene::SectionMesh     section =
      test::rectangle_mesh(test::equal_spacing(0., 60., 6), test::equal_spacing(-30., 30., 5));
    std::unique_ptr<Continuum> rock;
    ContinuumState             state;

    Waves()
    {
      scene.blocks.enabled        = false;
      scene.continuum.is_explicit = true;
      scene.continuum.degree      = 3;
      scene.time.newmark.beta     = 0.;
      scene.time.newmark.gamma    = 0.5;
      scene.motion.angle          = 30.;
      section.lines["bedding_1"]  = {{14, 15}, {15, 16}, {16, 17}};
    }

    void slant()
    {
      for (Vec2 &node : section.nodes)
        node += Vec2(0.1 * (node.y() + 30.), 0.05 * node.x());
    }

    void make()
    {
      std::vector<double> a;
      for (int i = 0; i < 100; ++i)
        a.push_back(3. * std::sin(0.4 * i) * std::exp(-0.02 * i));
      rock  = std::make_unique<Continuum>(section,
                                         scene,
                                         scene::GroundMotion{{2e-3, a}, scene.motion},
                                         MPI_COMM_SELF);
      state = rock->initial_state();
    }

    void step(const double dt, const int times)
    {
      for (int k = 0; k < times; ++k)
        ASSERT_TRUE(rock->step(state, dt));
    }

    ContinuumEnergy audit()
    {
      rock->collect(state, true);
      return rock->audit_energy(state);
    }
  };



  /// |sum of all terms| over the largest of them.
  double residual(const ContinuumEnergy &e)
  {
    const double sum = e.kinetic + e.strain + e.boundary_springs - e.input_work + e.boundary_loss +
                       e.damping_loss + e.integration_loss;
    double largest = 0.;
    for (const double term : {e.kinetic, e.strain, e.input_work, e.boundary_loss, e.damping_loss})
      largest = std::max(largest, std::abs(term));
    return std::abs(sum) / largest;
  }



  TEST(ExplicitWaves, EnergyClosesWithEveryBoundaryAndDamping)
  {
    using namespace scene;
    for (const auto &base : {compliant_base(), rigid_base(), fixed_base()})
      for (const auto &sides : {viscous_side(), free_field_side(), roller_side(), fixed_side()})
        for (const int damping : {0, 1, 2, 3})
          {
            Waves waves;
            waves.scene.continuum.base             = base;
            waves.scene.continuum.sides            = sides;
            waves.scene.bedding.names              = {"bedding_1"};
            waves.scene.continuum.boundary_springs = base.is_compliant;
            waves.scene.continuum.rayleigh_mass    = damping % 2 == 1 ? 0.5 : 0.;
            if (damping >= 2)
              {
                waves.scene.continuum.rayleigh_stiffness = 1e-4;
                waves.scene.maxwell.bedrock_ratio        = 0.05;
              }
            waves.scene.point_loads.loads     = {{"push", Vec2(33., -3.), Vec2(1e6, -2e6)}};
            waves.scene.point_loads.frequency = 20.;
            if (!sides.has_free_field)
              waves.slant();
            waves.make();
            waves.step(2e-3, 30);
            waves.step(1e-3, 10);
            const ContinuumEnergy energy = waves.audit();
            EXPECT_LT(residual(energy), 1e-11)
              << base.name << ' ' << sides.name << " damping " << damping;
            EXPECT_EQ(energy.damping_loss > 0., damping > 0);
          }
  }


  /// A motion of half the rock, left alone: nothing lets it out.
  Waves closed_box(const double damping)
  {
    Waves waves;
    waves.scene.continuum.base               = scene::fixed_base();
    waves.scene.continuum.sides              = scene::fixed_side();
    waves.scene.continuum.rayleigh_stiffness = damping;
    waves.make();
    for (std::size_t node = 0; node < waves.rock->node_positions().size(); ++node)
      if (const Vec2 &x = waves.rock->node_positions()[node]; (x - Vec2(30., -15.)).norm() < 12.)
        waves.state.velocity[2 * node] = 1.;
    return waves;
  }


  TEST(ExplicitWaves, TheStepIsDividedIntoPartsThatAreStable)
  {
    for (const double damping : {0., 2e-4})
      {
        Waves        waves  = closed_box(damping);
        const double before = waves.audit().kinetic;
        // the largest step that is one part
        double dt = 1e-6;
        while (waves.rock->parts_of_step(1.02 * dt) == 1)
          dt *= 1.02;
        EXPECT_EQ(waves.rock->parts_of_step(3.5 * dt), 4);
        waves.step(dt, 3000);
        const ContinuumEnergy after = waves.audit();
        EXPECT_LT(after.kinetic + after.strain, 1.3 * before) << damping; // less - dt^2/8 a M a
        EXPECT_GT(after.kinetic + after.strain + after.damping_loss, 0.7 * before) << damping;
        if (damping > 0.)
          continue; // the velocity that was given is not in equilibrium with its damping
        const double kept = after.kinetic + after.strain + after.integration_loss;
        EXPECT_NEAR(kept, before, 1e-11 * before);
      }
  }


  TEST(ExplicitWaves, StiffBoundarySpringsMakePartsShorter)
  {
    const auto parts = [](const double distance, const bool has_springs) {
      Waves waves;
      waves.scene.continuum.boundary_springs = has_springs;
      waves.scene.continuum.spring_distance  = distance;
      waves.make();
      waves.step(2e-3, 20);
      EXPECT_LT(residual(waves.audit()), 1e-11) << distance;
      return waves.rock->parts_of_step(2e-3);
    };
    EXPECT_EQ(parts(60., true), parts(60., false));
    EXPECT_GT(parts(1e-3, true), 2 * parts(1e-3, false));
  }


  TEST(ExplicitWaves, ErrorFallsWithTheSquareOfTheStep)
  {
    const auto run = [](const double dt) {
      Waves waves;
      waves.make();
      waves.step(dt, static_cast<int>(std::lround(0.12 / dt)));
      return waves.state.displacement;
    };
    const auto difference = [](const std::vector<double> &a, const std::vector<double> &b) {
      double sum = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
      return std::sqrt(sum);
    };
    const auto exact = run(6.25e-5), fine = run(2.5e-4), coarse = run(5e-4);
    EXPECT_NEAR(std::log2(difference(coarse, exact) / difference(fine, exact)), 2., 0.2);
  }


  TEST(ExplicitWaves, GoesOnFromACopyWithTheSameBits)
  {
    Waves waves;
    waves.scene.continuum.sides              = scene::free_field_side();
    waves.scene.continuum.rayleigh_stiffness = 1e-4;
    waves.scene.maxwell.bedrock_ratio        = 0.02;
    waves.scene.continuum.base               = scene::rigid_base();
    waves.make();
    waves.step(1e-3, 20);
    const ContinuumState copy = waves.state;
    waves.step(1e-3, 20);
    const ContinuumState first = waves.state;
    const double         loss  = waves.audit().damping_loss;
    waves.state                = copy;
    waves.audit(); // output changes no state
    waves.step(1e-3, 20);
    EXPECT_EQ(waves.state.displacement, first.displacement);
    EXPECT_EQ(waves.state.velocity, first.velocity);
    EXPECT_EQ(waves.state.acceleration, first.acceleration);
    EXPECT_EQ(waves.audit().damping_loss, loss);
  }
} // namespace
