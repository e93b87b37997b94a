// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/continuum.h>
#include <hybrid/continuum/stopped.h>
#include <hybrid/scene/boundary/fixed_base.h>
#include <hybrid/scene/boundary/fixed_side.h>
#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/rigid_base.h>
#include <hybrid/scene/boundary/roller_side.h>

#include <Eigen/Cholesky>

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


  /// What blocks that are not there do to a surface: forces of joints, of contacts, of what tore.
  SurfaceForce made_up_force(const Eigen::Index n, const int number)
  {
    Eigen::VectorXd all(n), contacts(n), ended(n);
    for (Eigen::Index k = 0; k < n; ++k)
      {
        all[k] = 1e6 * std::sin(0.7 * static_cast<double>(k) + 0.3 * number);
        contacts[k] =
          number % 4 == 0 ? 0. : 3e5 * std::cos(1.1 * static_cast<double>(k) - 0.2 * number);
        ended[k] =
          contacts[k] + (number % 3 == 0 ? 1e5 * std::sin(0.4 * static_cast<double>(k)) : 0.);
      }
    return {all, contacts, ended};
  }


  /// A step with these forces on the surface.
  void push(Continuum &rock, ContinuumState &state, const double dt, const SurfaceForce &force)
  {
    const Eigen::MatrixXd s    = rock.surface_stiffness(dt).dense();
    const Eigen::VectorXd load = rock.predict(state, dt);
    const double          beta = Newmark::preset("filtered").beta; // as that of "dissipative"
    const Eigen::VectorXd u = s.ldlt().solve(load + force.all + (0.5 / beta - 1.) * force.contacts);
    rock.correct(state, dt, u, force);
  }


  void expect_equal_motion_below_blocks(Scene &scene, const std::string &what)
  {
    SCOPED_TRACE(what);
    scene.parameters.blocks.enabled = true;
    test::add_block(scene.section);
    const auto factor    = scene.make(scene::LinearSolver::factor),
               krylov    = scene.make(scene::LinearSolver::conjugate_gradients);
    ContinuumState known = factor->initial_state(), found = krylov->initial_state();
    const auto     n = 2 * static_cast<Eigen::Index>(krylov->surface_nodes().size());
    Difference     displacement, velocity, acceleration, of_contacts;
    for (int k = 0; k < 24; ++k)
      {
        const double dt = k < 12 ? time_step : time_step / (1 + k % 4); // more sizes than are kept
        push(*factor, known, dt, made_up_force(n, k));
        push(*krylov, found, dt, made_up_force(n, k));
        displacement.add(found.displacement, known.displacement);
        velocity.add(found.velocity, known.velocity);
        acceleration.add(found.acceleration, known.acceleration);
        of_contacts.add(found.contact_acceleration, known.contact_acceleration);
      }
    for (const Difference &of : {displacement, velocity, acceleration, of_contacts})
      {
        EXPECT_GT(of.peak, 0.);
        EXPECT_LT(of.difference, 1e-9 * of.peak);
      }
    EXPECT_EQ(found.surface_force, known.surface_force);
    EXPECT_EQ(found.surface_contact, known.surface_contact);
    krylov->collect(found, true);
    const ContinuumEnergy one = krylov->audit_energy(found), other = factor->audit_energy(known);
    expect_equal_energy(one, other);
    EXPECT_GT(std::abs(other.surface_work), 0.);
    EXPECT_NEAR(one.surface_work, other.surface_work, 1e-9 * std::abs(other.surface_work));
  }


  TEST(ImplicitWaves, MoveAsTheFactoredSystemBelowBlocksWithEveryBoundary)
  {
    using namespace scene;
    for (const auto &base : {compliant_base(), rigid_base(), fixed_base()})
      for (const auto &sides : {viscous_side(), free_field_side(), roller_side(), fixed_side()})
        {
          Scene scene;
          scene.set_scheme("filtered");
          scene.parameters.continuum.base             = base;
          scene.parameters.continuum.sides            = sides;
          scene.parameters.continuum.boundary_springs = base.is_compliant;
          expect_equal_motion_below_blocks(scene, base.name + ' ' + sides.name);
        }
  }


  TEST(ImplicitWaves, MoveAsTheFactoredSystemBelowBlocksWithDamping)
  {
    for (const std::string name : {"filtered", "dissipative"})
      for (const auto &base : {scene::compliant_base(), scene::rigid_base()})
        {
          Scene scene;
          scene.set_scheme(name);
          scene.parameters.continuum.base               = base;
          scene.parameters.continuum.sides              = scene::free_field_side();
          scene.parameters.continuum.rayleigh_mass      = 0.5;
          scene.parameters.continuum.rayleigh_stiffness = 1e-4;
          scene.parameters.maxwell.bedrock_ratio        = 0.05;
          expect_equal_motion_below_blocks(scene, name + ' ' + base.name);
        }
  }


  TEST(ImplicitWaves, StiffnessOfTheSurfaceIsThatOfTheFactor)
  {
    Scene scene;
    scene.set_scheme("filtered");
    scene.parameters.continuum.sides = scene::roller_side(); // supports at the surface's ends
    scene.parameters.blocks.enabled  = true;
    test::add_block(scene.section);
    const auto factor = scene.make(scene::LinearSolver::factor),
               krylov = scene.make(scene::LinearSolver::conjugate_gradients);
    for (const double dt : {time_step, 0.25 * time_step})
      {
        const Eigen::MatrixXd known = factor->surface_stiffness(dt).dense(),
                              found = krylov->surface_stiffness(dt).dense();
        ASSERT_EQ(found.rows(), known.rows());
        const Eigen::VectorXd scale = known.diagonal().cwiseSqrt().cwiseInverse();
        EXPECT_LT((scale.asDiagonal() * (found - known) * scale.asDiagonal()).cwiseAbs().maxCoeff(),
                  1e-12);
      }
  }


  TEST(ImplicitWaves, SearchForTheStiffnessOfTheSurfaceCanBeStopped)
  {
    Scene scene;
    scene.set_scheme("filtered");
    scene.parameters.blocks.enabled = true;
    test::add_block(scene.section);
    const auto rock  = scene.make(scene::LinearSolver::conjugate_gradients);
    int        asked = 0;
    rock->watch_search([&asked]() { return ++asked < 3; });
    EXPECT_THROW(rock->surface_stiffness(time_step), Stopped);
    EXPECT_EQ(asked, 3);
    rock->watch_search({}); // what was stopped leaves nothing behind
    const auto fresh = scene.make(scene::LinearSolver::conjugate_gradients);
    EXPECT_EQ(rock->surface_stiffness(time_step).entries,
              fresh->surface_stiffness(time_step).entries);
  }


  TEST(ImplicitWaves, GoOnBelowBlocksFromACopyWithTheSameBits)
  {
    Scene scene;
    scene.set_scheme("filtered");
    scene.parameters.blocks.enabled = true;
    test::add_block(scene.section);
    const auto     rock  = scene.make(scene::LinearSolver::conjugate_gradients);
    ContinuumState state = rock->initial_state();
    const auto     n     = 2 * static_cast<Eigen::Index>(rock->surface_nodes().size());
    const auto     go_on = [&](Continuum &with, const int from) {
      for (int k = from; k < from + 5; ++k)
        push(with, state, time_step, made_up_force(n, k));
    };
    go_on(*rock, 1);
    const ContinuumState copy = state;
    push(*rock, state, 0.5 * time_step, made_up_force(n, 3)); // a step that is taken back
    state = copy;
    go_on(*rock, 6);
    const ContinuumState first = state;
    state                      = copy;
    rock->collect(state, true); // output changes no state
    go_on(*scene.make(scene::LinearSolver::conjugate_gradients), 6);
    EXPECT_EQ(state.displacement, first.displacement);
    EXPECT_EQ(state.velocity, first.velocity);
    EXPECT_EQ(state.acceleration, first.acceleration);
    EXPECT_EQ(state.contact_acceleration, first.contact_acceleration);
    EXPECT_EQ(state.energy.surface_work, first.energy.surface_work);
  }
} // namespace
