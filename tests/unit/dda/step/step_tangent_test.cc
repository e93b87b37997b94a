// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/step/step_tangent.h>

#include <gtest/gtest.h>

#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// A step that has begun and is evaluated, with its tangent.
  struct Begun
  {
    FixedBaseRun run;
    StepProblem  problem;
    StepTangent  tangent;

    Begun(const scene::SceneParameters &parameters, const Vec2 &velocity)
      : run(square_blocks(3, 2), parameters, straight_foundation(0., 1., 4.))
    {
      // They press on each other, too, so that no contact is where it closes.
      for (int b = 0; b < run.model.n_blocks(); ++b)
        run.state.blocks[b].velocity.head<2>() = velocity - Vec2(0.2 * (b % 3), 0.1 * b);
      run.solver.solve(run.state, run.foundation, 2e-3); // finds the contacts
      tangent.begin(run.model, run.foundation);
      problem.begin(run.model, run.state, run.foundation, 2e-3);
      problem.evaluate();
      tangent.connect(problem);
      tangent.assemble(problem, {true, true});
    }

    Eigen::Index size() const
    {
      return 6 * run.model.n_blocks();
    }

    Eigen::VectorXd residual() const
    {
      return problem.left().of_unknowns.head(size());
    }

    /// A direction in which rotations and strains move corners as far as translations.
    Eigen::VectorXd direction() const
    {
      std::mt19937                     random(7);
      std::uniform_real_distribution<> part(-1., 1.);
      Eigen::VectorXd                  p = Eigen::VectorXd::Zero(problem.left().of_unknowns.size());
      for (Eigen::Index k = 0; k < size(); ++k)
        p[k] = part(random);
      return p;
    }
  };

  /// How forces turn with the blocks is left out of the tangent: overlaps over sizes.
  constexpr double turning = 5e-4;

  /// Largest part of K p that the residual's central difference along p differs by.
  double error_of_tangent(Begun &begun)
  {
    constexpr double      way = 1e-9; // [m]; no contact changes on it
    const Eigen::VectorXd p   = begun.direction();
    Eigen::VectorXd       k_p(p.size());
    begun.tangent.rows().multiply(p, k_p);
    begun.problem.move(p, way);
    begun.problem.evaluate();
    const Eigen::VectorXd ahead = begun.residual();
    begun.problem.move(p, -2. * way);
    begun.problem.evaluate();
    const Eigen::VectorXd difference = (ahead - begun.residual()) / (2. * way);
    return (difference + k_p.head(begun.size())).lpNorm<Eigen::Infinity>() /
           k_p.lpNorm<Eigen::Infinity>();
  }
} // namespace



TEST(StepTangent, is_the_derivative_of_the_residual_of_contacts_that_stick_and_slide)
{
  Begun sticking(block_parameters(60.), Vec2(0.01, -0.4));
  EXPECT_LT(error_of_tangent(sticking), turning);
  Begun sliding(block_parameters(10.), Vec2(2., -0.1));
  EXPECT_LT(error_of_tangent(sliding), turning);
  EXPECT_FALSE(sliding.tangent.rows().symmetric);
}



TEST(StepTangent, is_the_derivative_of_the_residual_of_bonds)
{
  scene::SceneParameters p             = block_parameters(30.);
  p.blocks.bonded                      = true;
  p.materials["rock"].tensile_strength = 1e9;
  p.materials["rock"].cohesion         = 1e9;
  Begun bonded(p, Vec2(0.1, 0.2));
  EXPECT_LT(error_of_tangent(bonded), turning);
}



TEST(StepTangent, solves_for_the_update_that_takes_the_residual_away)
{
  Begun           begun(block_parameters(60.), Vec2(0.01, -0.4));
  Eigen::VectorXd update;
  StepResult      result;
  begun.tangent.solve(begun.problem, 1e-12, update, result);
  Eigen::VectorXd product(update.size());
  begun.tangent.rows().multiply(update, product);
  EXPECT_LT((product - begun.problem.left().of_unknowns).norm(), 1e-10 * product.norm());
  EXPECT_GT(result.solver_iterations + result.factorizations, 0);
}



TEST(StepTangent, is_kept_while_it_serves_and_made_anew_where_it_is_outdated)
{
  Begun      begun(block_parameters(60.), Vec2(0.01, -0.4));
  const auto diagonal = [&] { return begun.tangent.rows().diagonal[0]; };
  const Mat6 before   = diagonal();
  begun.problem.move(begun.direction(), 1e-4);
  begun.problem.evaluate();
  begun.tangent.outdate();
  begun.tangent.repair(begun.problem, true, true);
  EXPECT_FALSE(begun.tangent.is_outdated());
  const Mat6 after = diagonal();
  EXPECT_NE(after, before);
  begun.problem.move(begun.direction(), -1e-4);
  begun.problem.evaluate();
  begun.tangent.repair(begun.problem, true, true);
  EXPECT_EQ(diagonal(), after);
}
