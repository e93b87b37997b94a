// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/step/step_problem.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// Six loose squares on a base, in a step of 2 ms that has begun.
  struct Heap
  {
    FixedBaseRun run;
    StepProblem  problem;

    explicit Heap(const Vec2 &velocity = Vec2(0.3, -0.4))
      : run(square_blocks(3, 2), block_parameters(30.), straight_foundation(0., 1., 4.))
    {
      for (BlockState &block : run.state.blocks)
        block.velocity.head<2>() = velocity;
      run.solver.solve(run.state, run.foundation, 2e-3); // finds the contacts
      problem.begin(run.model, run.state, run.foundation, 2e-3);
    }

    Eigen::VectorXd some_update() const
    {
      Eigen::VectorXd update = Eigen::VectorXd::Zero(problem.left().of_unknowns.size());
      for (Eigen::Index k = 0; k < update.size(); ++k)
        update[k] = 1e-5 * static_cast<double>(k % 7 - 3);
      return update;
    }
  };
} // namespace



TEST(StepProblem, the_residual_depends_on_the_trial_alone)
{
  Heap         heap;
  const double first = heap.problem.evaluate();
  EXPECT_GT(first, 1e-3);
  const Eigen::VectorXd residual = heap.problem.left().of_unknowns;
  TrialPlace            place;
  heap.problem.keep(place);
  heap.problem.move(heap.some_update(), 1.);
  EXPECT_NE(heap.problem.evaluate(), first);
  EXPECT_EQ(heap.problem.go_back(place), first);
  EXPECT_EQ(heap.problem.left().of_unknowns, residual);
}



TEST(StepProblem, a_trial_that_is_not_accepted_changes_no_state)
{
  Heap             heap;
  const BlockState before = heap.run.state.blocks[4];
  heap.problem.evaluate();
  heap.problem.move(heap.some_update(), 1.);
  heap.problem.evaluate();
  EXPECT_EQ(heap.run.state.blocks[4].centroid, before.centroid);
  EXPECT_EQ(heap.run.state.blocks[4].velocity, before.velocity);
  EXPECT_EQ(heap.run.state.time, 0.);
}



TEST(StepProblem, what_is_accepted_is_where_the_trial_was)
{
  Heap heap;
  heap.problem.evaluate();
  heap.problem.finish(false);
  const Vec6 d      = heap.problem.trial.increment[4];
  const Vec2 before = heap.run.state.blocks[4].centroid;
  heap.problem.accept(heap.run.state);
  EXPECT_NEAR((heap.run.state.blocks[4].centroid - before - d.head<2>()).norm(), 0., 1e-15);
  EXPECT_DOUBLE_EQ(heap.run.state.time, 2e-3);
}



TEST(StepProblem, a_trial_without_motion_moves_nothing_and_leaves_the_momentum_there_was)
{
  Heap moving, resting(Vec2::Zero());
  for (Heap *heap : {&moving, &resting})
    {
      std::fill(heap->problem.trial.increment.begin(),
                heap->problem.trial.increment.end(),
                Vec6::Zero());
      heap->problem.evaluate();
    }
  EXPECT_TRUE(resting.problem.moves_nothing());
  EXPECT_TRUE(moving.problem.moves_nothing());
  EXPECT_FALSE(moving.problem.lies_in_balance());
}



TEST(StepProblem, held_bodies_keep_their_places_and_their_residual)
{
  Heap heap;
  heap.problem.evaluate();
  const Eigen::VectorXd residual = heap.problem.left().of_unknowns;
  const LocalSystem     nobody;
  heap.problem.narrow(nobody);
  const std::vector<Vec6> places = heap.problem.trial.increment;
  heap.problem.move(heap.some_update(), 1.);
  heap.problem.evaluate();
  EXPECT_TRUE(heap.problem.is_narrow());
  EXPECT_EQ(heap.problem.trial.increment, places);
  EXPECT_EQ(heap.problem.left().of_unknowns, residual);
  heap.problem.widen();
  heap.problem.move(heap.some_update(), 1.);
  heap.problem.evaluate();
  EXPECT_NE(heap.problem.left().of_unknowns, residual);
}
