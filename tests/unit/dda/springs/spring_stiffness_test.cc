// SPDX-License-Identifier: GPL-3.0-or-later
#include "spring_scene.h"

#include <hybrid/dda/springs/spring_stiffness.h>
#include <hybrid/dda/step/initial_state.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  constexpr int n_blocks = 5;

  /// Bonded squares in a row, which can be sheared apart between the last two.
  struct Row
  {
    Model           model;
    DdaState        state;
    Springs         springs;
    Trial           trial;
    SpringStiffness stiffness;
    BlockMatrix     matrix;

    Row()
    {
      scene::SceneParameters p             = block_parameters(30.);
      p.materials["rock"].cohesion         = 1e3;
      p.materials["rock"].tensile_strength = 1e9;
      p.blocks.bonded                      = true;
      model = build_model(square_blocks(n_blocks, 1), p, straight_foundation(0., -20., 30., 1));
      state = initial_state(model);
      springs.collect(model, state);
      springs.connect(model, matrix);
      trial.dt = 1e-3;
      trial.rate.assign(n_blocks, Vec6::Zero());
      trial.foundation = Eigen::VectorXd::Zero(2 * model.n_foundation_nodes());
      move(0., 0.);
      assemble(true);
    }

    /// The row turns as a whole about the origin, and the last block is lifted.
    void move(const double angle, const double lift)
    {
      const Eigen::Rotation2Dd turn(angle);
      trial.increment.assign(n_blocks, Vec6::Zero());
      for (int b = 0; b < n_blocks; ++b)
        {
          const Vec2 &c                = state.blocks[b].centroid;
          trial.increment[b].head<2>() = turn * c - c;
          trial.increment[b][2]        = angle;
        }
      trial.increment.back()[1] += lift;
      trial.motion.clear();
      trial.displacement.resize(state.geometry.vertices.size());
      for (int b = 0; b < n_blocks; ++b)
        {
          trial.motion.emplace_back(state.blocks[b].centroid, trial.increment[b]);
          for (int v = state.geometry.offset[b]; v < state.geometry.offset[b + 1]; ++v)
            trial.displacement[v] = trial.motion[b].displacement(state.geometry.vertices[v]);
        }
      springs.evaluate(model, state, trial);
    }

    void assemble(const bool all)
    {
      stiffness.update(springs, trial, {true, 1., 0., all});
      for (const int b : stiffness.changed_blocks())
        {
          matrix.set_row_zero(b);
          stiffness.add_rows(springs, b, matrix);
        }
      matrix.set_nodes_zero();
      stiffness.add_foundation(springs, matrix);
    }
  };
} // namespace



TEST(SpringStiffness, tangent_is_the_derivative_of_the_forces)
{
  for (const bool bonded : {true, false})
    for (const double damping : {0., 0.05})
      {
        SpringScene           scene(bonded, damping);
        const Eigen::VectorXd d = pressing(1e-6);
        scene.move(d);
        BlockMatrix matrix;
        scene.springs.connect(scene.model, matrix);
        matrix.set_zero();
        SpringStiffness stiffness;
        stiffness.update(scene.springs, scene.trial, {});
        for (const int b : stiffness.changed_blocks())
          stiffness.add_rows(scene.springs, b, matrix);
        stiffness.add_foundation(scene.springs, matrix);
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
            // damping with the step's own rate would add a moving-foundation term
            const int rows = damping > 0. ? 12 : 20;
            if (damping == 0. || i < 12)
              {
                EXPECT_LT((column - difference).head(rows).norm(), 1e-4 * column.norm()) << i;
              }
          }
      }
}



TEST(SpringStiffness, only_blocks_beside_a_joint_that_slides_are_made_anew)
{
  Row row;
  EXPECT_EQ(row.stiffness.changed_blocks().size(), static_cast<std::size_t>(n_blocks));
  row.assemble(false);
  EXPECT_TRUE(row.stiffness.changed_blocks().empty());

  row.move(0., 1e-5); // beyond cohesion / shear stiffness
  row.assemble(false);
  EXPECT_EQ(row.stiffness.changed_blocks(), (std::vector<int>{n_blocks - 2, n_blocks - 1}));

  const BlockMatrix part = row.matrix;
  row.assemble(true);
  EXPECT_EQ(part.symmetric, row.matrix.symmetric);
  for (int b = 0; b < n_blocks; ++b)
    EXPECT_LT((part.diagonal[b] - row.matrix.diagonal[b]).norm(),
              1e-4 * row.matrix.diagonal[b].norm());
  for (std::size_t s = 0; s < part.pairs.size(); ++s)
    EXPECT_LT((part.lower[s] - row.matrix.lower[s]).norm(), 1e-4 * row.matrix.lower[s].norm());
}



TEST(SpringStiffness, joints_that_have_turned_are_made_anew)
{
  for (const double angle : {1e-6, 1e-3})
    {
      Row row;
      row.move(angle, 0.);
      row.assemble(false);
      EXPECT_EQ(row.stiffness.changed_blocks().size(),
                static_cast<std::size_t>(angle > 1e-4 ? n_blocks : 0))
        << angle;
    }
}
