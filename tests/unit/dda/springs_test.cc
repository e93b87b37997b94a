// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/springs.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// Two squares side by side on a base of three segments, bonded to each other or not.
  struct Scene
  {
    Model    model;
    DdaState state;
    Springs  springs;
    Trial    trial;

    explicit Scene(const bool bonded, const double damping_ratio = 0.)
    {
      scene::SceneParameters p             = block_parameters(85.); // nothing slides
      p.materials["rock"].cohesion         = 1e9;
      p.materials["rock"].tensile_strength = 1e9;
      p.blocks.bonded                      = bonded;
      p.blocks.damping_ratio               = damping_ratio;
      model = build_model(square_blocks(2, 1), p, straight_base(0., 0.3, 2.3, 3));
      state = initial_state(model);
      for (int v = 0; v < 8; ++v) // corners 0, 1 of both blocks stand on the base
        if (v % 4 < 2)
          {
            const double x = state.geometry.vertices[v].x(), s = (x + 0.3) / 2.6 * 3.;
            const int    segment = std::min(2, static_cast<int>(s));
            state.contacts.push_back(
              {state.geometry.block_of[v], v, base_body, segment, s - segment});
          }
      if (!bonded) // a corner of the second block in the side of the first
        {
          state.geometry.vertices[7].y() -= 0.25;
          state.contacts.push_back({1, 7, 0, 1, 0.75});
        }
      springs.collect(model, state);
      trial.dt = 1e-3;
      trial.increment.assign(2, Vec6::Zero());
      trial.rate.assign(2, Vec6::Zero());
      trial.base = Eigen::VectorXd::Zero(8);
    }

    void move(const Eigen::VectorXd &d)
    {
      trial.motion.clear();
      trial.displacement.resize(8);
      for (int b = 0; b < 2; ++b)
        {
          trial.increment[b] = d.segment<6>(6 * b);
          trial.motion.emplace_back(state.blocks[b].centroid, trial.increment[b]);
          for (int v = 4 * b; v < 4 * b + 4; ++v)
            trial.displacement[v] = trial.motion[b].displacement(state.geometry.vertices[v]);
        }
      trial.base = d.tail(8);
      springs.evaluate(model, state, trial);
    }

    Eigen::VectorXd forces(const Eigen::VectorXd &d)
    {
      move(d);
      Eigen::VectorXd f = Eigen::VectorXd::Zero(20), absolute = Eigen::VectorXd::Zero(2);
      springs.add_forces(f, f, absolute);
      return f;
    }

    double energy(const Eigen::VectorXd &d)
    {
      move(d);
      double sum = 0.;
      for (std::size_t s = 0; s < springs.springs.size(); ++s)
        {
          const SpringState &now = springs.responses[s].now;
          sum += springs.springs[s].length *
                 springs.springs[s].law->stored_energy({now.gap, now.slip}, now.history);
        }
      return sum;
    }
  };



  /// A small displacement that presses the blocks onto the base and onto one another.
  Eigen::VectorXd pressing(const double size)
  {
    Eigen::VectorXd d(20);
    d << 0.6, -1., 0.2, 0.1, -0.1, 0.2, -0.5, -1.2, -0.1, 0.1, 0.2, -0.1, 0.02, 0.05, -0.03, 0.02,
      0.04, 0.03, 0.01, -0.05;
    return size * d;
  }
} // namespace



TEST(Springs, every_joint_end_and_every_contact_is_one_spring)
{
  EXPECT_EQ(Scene(true).springs.springs.size(), 2u + 4u);
  EXPECT_EQ(Scene(false).springs.springs.size(), 5u);
}



TEST(Springs, no_displacement_no_force)
{
  for (const bool bonded : {true, false})
    EXPECT_LT(Scene(bonded).forces(Eigen::VectorXd::Zero(20)).norm(), 1e-5); // N; k is 1e9 N/m
}



TEST(Springs, action_equals_reaction_in_force_and_moment)
{
  for (const bool bonded : {true, false})
    for (const double damping : {0., 0.05})
      {
        Scene scene(bonded, damping);
        scene.trial.rate[0] << 0.1, -0.2, 0.3, 0.1, 0.2, 0.1;
        const Eigen::VectorXd f      = scene.forces(pressing(1e-5));
        Vec2                  sum    = Vec2::Zero();
        double                moment = 0.;
        for (int b = 0; b < 2; ++b)
          {
            const Vec2 force = f.segment<2>(6 * b);
            sum += force;
            moment += cross(scene.trial.motion[b].centroid, force) + f[6 * b + 2];
          }
        double largest = 0.;
        for (int k = 0; k < 4; ++k)
          {
            const Vec2 force = f.segment<2>(12 + 2 * k);
            const Vec2 place =
              scene.model.initial.base_nodes[k] + scene.trial.base.segment<2>(2 * k);
            sum += force;
            moment += cross(place, force);
            largest = std::max(largest, force.norm());
          }
        EXPECT_GT(largest, 1e3);
        EXPECT_LT(sum.norm(), 1e-10 * largest);
        // a contact force acts at the vertex, which is off its segment by the penetration (1e-5 m)
        EXPECT_LT(std::abs(moment), 3e-5 * largest);
      }
}



TEST(Springs, forces_are_the_gradient_of_the_stored_energy)
{
  for (const bool bonded : {true, false})
    {
      Scene                 scene(bonded);
      const Eigen::VectorXd d = pressing(1e-6), f = scene.forces(d);
      for (int i = 0; i < 20; ++i)
        {
          const double    h    = 1e-8;
          Eigen::VectorXd plus = d, minus = d;
          plus[i] += h;
          minus[i] -= h;
          const double slope = (scene.energy(plus) - scene.energy(minus)) / (2. * h);
          EXPECT_NEAR(f[i], -slope, 1e-4 * f.norm()) << i << (bonded ? " bonded" : " loose");
        }
    }
}



TEST(Springs, tangent_is_the_derivative_of_the_forces)
{
  for (const bool bonded : {true, false})
    for (const double damping : {0., 0.05})
      {
        Scene                 scene(bonded, damping);
        const Eigen::VectorXd d = pressing(1e-6);
        scene.move(d);
        BlockMatrix matrix;
        scene.springs.connect(scene.model, matrix);
        matrix.set_zero();
        scene.springs.add_stiffness(scene.trial, {}, matrix);
        Eigen::VectorXd column(20);
        for (int i = 0; i < 20; ++i)
          {
            const double    h    = 1e-8;
            Eigen::VectorXd plus = d, minus = d;
            plus[i] += h;
            minus[i] -= h;
            const Eigen::VectorXd difference =
              -(scene.forces(plus) - scene.forces(minus)) / (2. * h);
            matrix.multiply(Eigen::VectorXd::Unit(20, i), column);
            // damping with the step's own rate would add a moving-base term
            const int rows = damping > 0. ? 12 : 20;
            if (damping == 0. || i < 12)
              {
                EXPECT_LT((column - difference).head(rows).norm(), 1e-4 * column.norm()) << i;
              }
          }
      }
}



TEST(Springs, damping_resists_the_rate)
{
  Scene           scene(true, 0.05);
  Eigen::VectorXd d       = Eigen::VectorXd::Zero(20);
  d[6]                    = 1e-6; // the second block moves away from the first [m]
  const Eigen::VectorXd f = scene.forces(d);
  // k_n (1 + b_K / dt) d on the whole edge: b_K = ratio / (pi f), k_n = 40 E / (2 m)
  const double expected = (40. * 50e6 / 2.) * (1. + 0.05 / (M_PI * 2.) / scene.trial.dt) * 1e-6;
  EXPECT_NEAR(f[6], -expected, 1e-6 * expected);
  EXPECT_NEAR(f[0], expected, 1e-6 * expected);
}



TEST(Springs, rigid_rotation_of_a_bonded_pair_gives_no_force)
{
  Scene           scene(true);
  const double    angle = 0.01;
  Eigen::VectorXd d     = Eigen::VectorXd::Zero(20);
  const Vec2      pivot(1., 0.5);
  scene.state.contacts.clear();
  scene.springs.collect(scene.model, scene.state);
  for (int b = 0; b < 2; ++b)
    {
      const Vec2 r = scene.state.blocks[b].centroid - pivot;
      d[6 * b]     = (std::cos(angle) - 1.) * r.x() - std::sin(angle) * r.y();
      d[6 * b + 1] = (std::cos(angle) - 1.) * r.y() + std::sin(angle) * r.x();
      d[6 * b + 2] = angle;
    }
  EXPECT_LT(scene.forces(d).norm(), 1e-5); // N; k is 1e9 N/m
}



TEST(Springs, contacts_do_not_depend_on_the_place_in_the_section)
{
  // Far from the origin the gap keeps its digits: forces differ by the round-off of the places
  // only.
  Scene      near(false), far(false);
  const Vec2 offset(512., 256.);
  for (Vec2 &x : far.state.geometry.vertices)
    x += offset;
  for (Vec2 &x : far.state.geometry.base_nodes)
    x += offset;
  for (BlockState &block : far.state.blocks)
    block.centroid += offset;
  far.springs.collect(far.model, far.state);
  const Eigen::VectorXd a = near.forces(pressing(1e-6)), b = far.forces(pressing(1e-6));
  const Eigen::VectorXd a0 = near.forces(pressing(0.)), b0 = far.forces(pressing(0.));
  EXPECT_LT(((a - a0) - (b - b0)).norm(), 1e-9 * a.norm());
}
