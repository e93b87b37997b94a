// SPDX-License-Identifier: GPL-3.0-or-later
// The condensed solution of blocks on bedrock equals a monolithic one: all unknowns of rock and
// blocks in dense matrices, the joints' springs assembled here on their own, one LU factorisation
// per step size, the same Newmark scheme. The motion is so small (strains of 1e-11) that geometry
// is linear to round-off.
#include "coupled_scenes.h"

#include <hybrid/continuum/boundary_forces.h>
#include <hybrid/continuum/elastic_assembly.h>

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  /// Everything in one dense system: rock first, six unknowns per block after it.
  struct Monolith
  {
    Monolith(const CoupledRun &run, const scene::SectionMesh &section, const scene::Motion &motion)
      : newmark(run.scene.time.newmark)
      , rock(continuum::split_bedding_planes(section, {}))
      , space(rock, section, run.scene.continuum.degree, MPI_COMM_WORLD)
      , material(rock.cells.size(), run.scene.materials.at("rock"))
      , boundary(rock, space.nodes, material, section, run.scene, {motion, run.scene.motion})
      , n_rock(2 * static_cast<int>(space.nodes.positions.size()))
    {
      const int n = n_rock + 6 * run.model.n_blocks();
      mass = stiffness = damping = Eigen::MatrixXd::Zero(n, n);
      u = v = a = Eigen::VectorXd::Zero(n);
      add_rock(run.scene.continuum);
      add_blocks(run);
      for (const dda::Joint &joint : run.model.joints)
        for (const dda::Joint::Point &point : joint.points)
          add_spring(run, joint, point);
    }

    void add_rock(const scene::ContinuumParameters &scene)
    {
      const auto          m = continuum::assemble_elastic(space, rock, material, {});
      std::vector<double> dashpots(m.stiffness.size(), 0.);
      boundary.add_dashpots(m, 1., dashpots);
      for (int i = 0; i < m.n_nodes(); ++i)
        for (int e = m.row_start[i]; e < m.row_start[i + 1]; ++e)
          for (int k = 0; k < 4; ++k)
            {
              const int r = 2 * i + k / 2, c = 2 * m.column[e] + k % 2;
              mass(r, c)      = k % 3 == 0 ? m.mass[e] : 0.;
              stiffness(r, c) = m.stiffness[4 * e + k];
              damping(r, c)   = dashpots[4 * e + k];
            }
      damping += scene.rayleigh_mass * mass + scene.rayleigh_stiffness * stiffness;
    }

    void add_blocks(const CoupledRun &run)
    {
      for (int b = 0; b < run.model.n_blocks(); ++b)
        {
          const dda::BlockProperties &p = run.model.blocks[b];
          const int                   o = n_rock + 6 * b;
          mass.block<6, 6>(o, o)        = dda::mass_matrix(p, 0.);
          stiffness.block<3, 3>(o + 3, o + 3) += p.area * p.elasticity;
          damping.block<3, 3>(o + 3, o + 3) += p.damping_time * p.area * p.elasticity;
        }
    }

    /// Displacement of a point of block b by its six unknowns.
    static Eigen::Matrix<double, 2, 6> shape(const CoupledRun &run, const int b, const Vec2 &x)
    {
      const Vec2                  r = x - run.state.blocks.blocks[b].centroid;
      Eigen::Matrix<double, 2, 6> t;
      t << 1., 0., -r.y(), r.x(), 0., 0.5 * r.y(), 0., 1., r.x(), 0., r.y(), 0.5 * r.x();
      return t;
    }

    void add_spring(const CoupledRun &run, const dda::Joint &joint, const dda::Joint::Point &point)
    {
      const dda::Geometry &g    = run.model.initial;
      const Vec2           from = g.vertices[joint.edge], to = g.vertices[g.next(joint.edge)];
      const Vec2           t = (to - from).normalized(), n(t.y(), -t.x());
      const Vec2           p = from + point.position * (to - from);

      Eigen::MatrixXd jump = Eigen::MatrixXd::Zero(2, u.size());
      jump.block<2, 6>(0, n_rock + 6 * joint.block) -= shape(run, joint.block, p);
      if (joint.other == dda::foundation_body)
        {
          for (std::size_t k = 0; k < space.nodes.positions.size(); ++k)
            if ((space.nodes.positions[k] - g.foundation_nodes[point.other_vertex]).norm() < 1e-9)
              jump.block<2, 2>(0, 2 * k).setIdentity();
        }
      else
        jump.block<2, 6>(0, n_rock + 6 * joint.other) +=
          shape(run, joint.other, g.vertices[point.other_vertex]);
      const Eigen::MatrixXd gap = n.transpose() * jump, slip = t.transpose() * jump;
      stiffness += 0.5 * joint.length *
                   (joint.law.normal_stiffness() * gap.transpose() * gap +
                    joint.law.shear_stiffness() * slip.transpose() * slip);
    }

    void step(const double dt)
    {
      time += dt;
      continuum::BoundaryForces::Incoming in;
      boundary.incoming(time, nullptr, nullptr, in);
      Eigen::VectorXd force = Eigen::VectorXd::Zero(u.size());
      for (std::size_t k = 0; k < boundary.boundary_nodes().size(); ++k)
        for (int c = 0; c < 2; ++c)
          force[2 * boundary.boundary_nodes()[k] + c] += in.force[2 * k + c];
      const double          b = newmark.beta, g = newmark.gamma;
      const Eigen::VectorXd us = u + dt * v + dt * dt * (0.5 - b) * a, vs = v + dt * (1. - g) * a;
      const Eigen::MatrixXd lhs = mass + g * dt * damping + b * dt * dt * stiffness;
      a                         = lhs.partialPivLu().solve(force - damping * vs - stiffness * us);
      u                         = us + b * dt * dt * a;
      v                         = vs + g * dt * a;
    }

    Newmark                   newmark;
    continuum::RockMesh       rock;
    continuum::ElementSpace   space;
    std::vector<Material>     material;
    continuum::BoundaryForces boundary;
    int                       n_rock;
    double                    time = 0.;
    Eigen::MatrixXd           mass, stiffness, damping;
    Eigen::VectorXd           u, v, a;
  };



  /// Rates of rock and blocks in the monolith's order.
  Eigen::VectorXd rates(const CoupledRun &run, const int n_rock, const bool acceleration)
  {
    const auto &rock =
      acceleration ? run.state.continuum.acceleration : run.state.continuum.velocity;
    const int       n = run.model.n_blocks();
    Eigen::VectorXd all(n_rock + 6 * n);
    all.head(n_rock) = Eigen::Map<const Eigen::VectorXd>(rock.data(), n_rock);
    for (int b = 0; b < n; ++b)
      all.segment<6>(n_rock + 6 * b) = acceleration ? run.state.blocks.blocks[b].acceleration
                                                    : run.state.blocks.blocks[b].velocity;
    return all;
  }



  void expect_equal(const double modulus_ratio, const int degree)
  {
    Section layout;
    layout.columns      = 6;
    layout.first        = 2;
    layout.mass_columns = 2;
    layout.size         = 5.;

    scene::SceneParameters scene       = coupled_parameters();
    scene.environment.gravity          = 0.;
    scene.blocks.tolerance             = modulus_ratio > 1. ? 1e-10 : 1e-13;
    scene.continuum.degree             = degree;
    scene.continuum.rayleigh_mass      = 0.3;
    scene.continuum.rayleigh_stiffness = 2e-4;
    scene.materials["rock"].young_modulus *= modulus_ratio;

    std::vector<double> a;
    for (int i = 0; i <= 40; ++i)
      a.push_back(1e-7 * std::sin(M_PI * i / 20.));
    const scene::Motion motion(1e-3, a);

    CoupledRun run(layout, scene, motion);
    Monolith   reference(run, section_mesh(layout), motion);
    // Blocks that tumble, so that every spring works from the start.
    std::mt19937                           generator(5);
    std::uniform_real_distribution<double> random(-1e-9, 1e-9);
    for (int b = 0; b < run.model.n_blocks(); ++b)
      for (int k = 0; k < 6; ++k)
        reference.v[reference.n_rock + 6 * b + k] = run.state.blocks.blocks[b].velocity[k] =
          random(generator);

    double worst = 0.;
    for (int k = 0; k < 40; ++k)
      {
        const double dt = k % 8 == 7 ? 5e-4 : 1e-3;
        ASSERT_TRUE(run.advance(dt));
        reference.step(dt);
        const Eigen::VectorXd dv = rates(run, reference.n_rock, false) - reference.v,
                              da = rates(run, reference.n_rock, true) - reference.a;
        worst = std::max({worst, dv.norm() / reference.v.norm(), da.norm() / reference.a.norm()});
      }
    const Eigen::Map<const Eigen::VectorXd> u(run.state.continuum.displacement.data(),
                                              reference.n_rock);
    EXPECT_LT((u - reference.u.head(reference.n_rock)).norm(),
              1e-9 * reference.u.head(reference.n_rock).norm());
    EXPECT_LT(worst, 1e-9);
    std::printf(
      "modulus ratio %g, degree %d: largest difference of velocity and acceleration %.1e\n",
      modulus_ratio,
      degree,
      worst);
  }
} // namespace



TEST(CouplingMonolithic, equal_stiffness)
{
  expect_equal(1., 2);
}



TEST(CouplingMonolithic, linear_elements)
{
  expect_equal(1., 1);
}



TEST(CouplingMonolithic, soft_rock)
{
  expect_equal(1e-3, 2);
}



TEST(CouplingMonolithic, hard_rock)
{
  expect_equal(1e6, 2);
}
