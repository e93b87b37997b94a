// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/boundary_forces.h>
#include <hybrid/continuum/continuum.h>
#include <hybrid/continuum/elastic_assembly.h>
#include <hybrid/scene/boundary/roller_side.h>

#include <Eigen/Cholesky>

#include "rectangle_mesh.h"

#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  /// Newmark's method with dense matrices and nothing condensed.
  struct DenseReference
  {
    DenseReference(const scene::SectionMesh &section, const scene::SceneParameters &scene)
      : newmark(scene.time.newmark)
    {
      const RockMesh              rock = split_bedding_planes(section, {});
      const ElementSpace          space(rock, section, scene.continuum.degree, MPI_COMM_WORLD);
      const std::vector<Material> material(rock.cells.size(), test::rock_material());
      const auto                  m = assemble_elastic(space, rock, material, {});
      const BoundaryForces        boundary(rock, space.nodes, material, section, scene, {});
      std::vector<double>         dashpots(m.stiffness.size(), 0.);
      boundary.add_dashpots(m, 1., dashpots);
      const int n = 2 * m.n_nodes();
      mass = stiffness = damping = Eigen::MatrixXd::Zero(n, n);
      for (int i = 0; i < m.n_nodes(); ++i)
        for (int e = m.row_start[i]; e < m.row_start[i + 1]; ++e)
          for (int k = 0; k < 4; ++k)
            {
              const int r = 2 * i + k / 2, c = 2 * m.column[e] + k % 2;
              mass(r, c)      = k % 3 == 0 ? m.mass[e] : 0.;
              stiffness(r, c) = m.stiffness[4 * e + k];
              damping(r, c)   = dashpots[4 * e + k];
            }
      damping +=
        scene.continuum.rayleigh_mass * mass + scene.continuum.rayleigh_stiffness * stiffness;
      positions = space.nodes.positions;
      u = v = a = Eigen::VectorXd::Zero(n);
    }

    void step(const double dt, const Eigen::VectorXd &force)
    {
      const double          b = newmark.beta, g = newmark.gamma;
      const Eigen::VectorXd us = u + dt * v + dt * dt * (0.5 - b) * a, vs = v + dt * (1. - g) * a;
      const Eigen::MatrixXd lhs = mass + g * dt * damping + b * dt * dt * stiffness;
      a                         = lhs.ldlt().solve(force - damping * vs - stiffness * us);
      u                         = us + b * dt * dt * a;
      v                         = vs + g * dt * a;
    }

    Newmark           newmark;
    Eigen::MatrixXd   mass, stiffness, damping;
    Eigen::VectorXd   u, v, a;
    std::vector<Vec2> positions;
  };
} // namespace


TEST(Condensation, equals_the_uncondensed_solve)
{
  auto section =
    test::rectangle_mesh(test::equal_spacing(0., 40., 5), test::equal_spacing(-20., 20., 3));
  test::add_block(section);
  auto scene                         = test::rock_scene();
  scene.continuum.rayleigh_mass      = 0.3;
  scene.continuum.rayleigh_stiffness = 2e-4;
  Continuum      continuum(section, scene, {}, MPI_COMM_WORLD);
  DenseReference reference(section, scene);

  const auto &surface = continuum.surface_nodes();
  ASSERT_EQ(surface.size(), 11u);
  std::vector<int> node_of;
  for (const Vec2 &p : surface)
    for (std::size_t k = 0; k < reference.positions.size(); ++k)
      if ((reference.positions[k] - p).norm() < 1e-9)
        node_of.push_back(static_cast<int>(k));
  ASSERT_EQ(node_of.size(), surface.size());

  auto                                   state = continuum.initial_state();
  std::mt19937                           generator(3);
  std::uniform_real_distribution<double> random(-1e6, 1e6);
  Eigen::VectorXd                        lambda(22);
  for (const double dt : {1e-3, 1e-3, 5e-4, 1e-3, 2.5e-4, 1.25e-4, 1e-3})
    {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(reference.u.size());
      for (int i = 0; i < 22; ++i)
        {
          lambda[i]                         = random(generator);
          force[2 * node_of[i / 2] + i % 2] = lambda[i];
        }
      reference.step(dt, force);
      const Eigen::VectorXd g  = continuum.predict(state, dt);
      const Eigen::VectorXd ug = continuum.surface_stiffness(dt).dense().ldlt().solve(g + lambda);
      continuum.correct(state, dt, ug, lambda);

      const Eigen::Map<Eigen::VectorXd> u(state.displacement.data(), reference.u.size());
      const Eigen::Map<Eigen::VectorXd> a(state.acceleration.data(), reference.a.size());
      EXPECT_LT((u - reference.u).norm(), 1e-9 * reference.u.norm());
      EXPECT_LT((a - reference.a).norm(), 1e-9 * reference.a.norm());
    }
}


TEST(Condensation, no_force_is_a_plain_step)
{
  auto section =
    test::rectangle_mesh(test::equal_spacing(0., 40., 4), test::equal_spacing(-20., 20., 2));
  test::add_block(section);
  Continuum continuum(section, test::rock_scene(), {}, MPI_COMM_WORLD);
  auto      state = continuum.initial_state();
  for (std::size_t i = 0; i < state.velocity.size(); ++i)
    state.velocity[i] = std::sin(0.7 * i);
  auto       other = state;
  const auto zero  = Eigen::VectorXd::Zero(2 * continuum.surface_nodes().size());
  for (int k = 0; k < 3; ++k)
    {
      continuum.step(state, 1e-3);
      const Eigen::VectorXd g = continuum.predict(other, 1e-3);
      continuum.correct(other,
                        1e-3,
                        continuum.surface_stiffness(1e-3).dense().ldlt().solve(g),
                        zero);
    }
  for (std::size_t i = 0; i < state.velocity.size(); ++i)
    EXPECT_NEAR(state.velocity[i], other.velocity[i], 1e-11);
}


TEST(Condensation, a_supported_end_of_the_surface_does_not_move)
{
  auto section =
    test::rectangle_mesh(test::equal_spacing(0., 40., 4), test::equal_spacing(-20., 20., 2));
  test::add_block(section);
  auto scene            = test::rock_scene();
  scene.continuum.sides = scene::roller_side();
  Continuum       continuum(section, scene, {}, MPI_COMM_WORLD);
  auto            state  = continuum.initial_state();
  Eigen::VectorXd lambda = Eigen::VectorXd::Constant(2 * continuum.surface_nodes().size(), 1e6);
  for (int k = 0; k < 3; ++k)
    {
      const Eigen::VectorXd g  = continuum.predict(state, 1e-3);
      const Eigen::VectorXd ug = continuum.surface_stiffness(1e-3).dense().ldlt().solve(g + lambda);
      EXPECT_LT(std::abs(ug[0]), 1e-5 * std::abs(ug[1]));
      continuum.correct(state, 1e-3, ug, lambda);
    }
  const auto corner = continuum.point({0., 0.});
  EXPECT_EQ(continuum.sample(state, corner).displacement.x(), 0.);
  EXPECT_NE(continuum.sample(state, corner).displacement.y(), 0.);
}
