// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/step/settled_islands.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// Five blocks: 3 hangs on 0 and 4 on 1 by springs, both 1 and 2 lie on the base.
  struct FiveBlocks
  {
    Springs         springs;
    SettledIslands  islands;
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(30), scale = Eigen::VectorXd::Ones(30),
                    forces = Eigen::VectorXd::Ones(5);

    FiveBlocks()
    {
      const auto connect = [this](const int block, const int other) {
        Springs::Spring spring;
        spring.block = block;
        spring.other = other;
        springs.springs.push_back(spring);
        springs.bodies.push_back({spring.block, spring.other, {0, 0}});
      };
      connect(3, 0);
      connect(4, 1);
      connect(1, foundation_body);
      connect(2, foundation_body);
      islands.begin(5);
    }

    bool settle()
    {
      return islands.settle({residual, scale, forces}, 1e-3, springs);
    }

    std::vector<int> settled_springs() const
    {
      std::vector<int> numbers;
      for (std::size_t s = 0; s < springs.springs.size(); ++s)
        if (springs.springs[s].settled)
          numbers.push_back(static_cast<int>(s));
      return numbers;
    }
  };

  /// Two squares of a column that falls on the base, and the way of the lower one's centroid in
  /// 60 ms; a third one flies far from both.
  Vec2 fall(const bool beside_another, int &iterations)
  {
    scene::SectionMesh mesh = square_blocks(1, 2);
    if (beside_another)
      {
        for (const Vec2 &corner : {Vec2(10., 50.), Vec2(11., 50.), Vec2(11., 51.), Vec2(10., 51.)})
          mesh.nodes.push_back(corner);
        mesh.blocks.push_back({6, 7, 8, 9});
        mesh.block_region.push_back(0);
      }
    FixedBaseRun run(mesh, block_parameters(30.), straight_foundation(0.05, 5., 20.));
    for (auto &block : run.state.blocks)
      block.velocity[1] = -1.;
    const Vec2 start = run.state.blocks[0].centroid;
    EXPECT_TRUE(run.run(0.06, 1e-3));
    iterations = run.iterations;
    return run.state.blocks[0].centroid - start;
  }
} // namespace



TEST(SettledIslands, base_connects_nothing)
{
  FiveBlocks five;
  five.residual[6 * 4] = 0.1; // of 1 and 4
  EXPECT_TRUE(five.settle());
  EXPECT_EQ(five.islands.at_work(), (std::vector<int>{1, 4}));
  EXPECT_EQ(five.settled_springs(), (std::vector<int>{0, 3}));
}



TEST(SettledIslands, island_is_judged_as_a_whole_by_its_own_forces)
{
  FiveBlocks five;
  five.residual[0]     = 1.1e-3; // of 0, which has no share of its own
  five.residual[6 * 2] = 1.1e-3;
  five.residual[6 * 1] = 0.9e-3;
  five.forces[3]       = 2.;
  EXPECT_TRUE(five.settle());
  EXPECT_EQ(five.islands.at_work(), (std::vector<int>{2}));
}



TEST(SettledIslands, stay_settled_until_they_are_woken)
{
  FiveBlocks five;
  five.residual[6 * 2] = 1.;
  EXPECT_TRUE(five.settle());
  five.residual[0] = 1.;
  EXPECT_FALSE(five.settle());
  EXPECT_TRUE(five.islands.is_settled(0));
  five.islands.wake(five.springs);
  EXPECT_EQ(five.islands.at_work().size(), 5u);
  EXPECT_TRUE(five.settled_springs().empty());
}



TEST(SettledIslands, one_island_is_never_settled)
{
  FiveBlocks five;
  five.springs.bodies[2].other = five.springs.springs[2].other = 0;
  five.springs.bodies[3].other = five.springs.springs[3].other = 1;
  EXPECT_FALSE(five.settle());
  EXPECT_EQ(five.islands.at_work().size(), 5u);
}



TEST(SettledIslands, few_blocks_are_at_work_alone_for_a_while)
{
  FiveBlocks five;
  five.residual[6 * 4] = 0.1; // of 1 and 4
  EXPECT_TRUE(five.settle());
  five.islands.narrow({4});
  EXPECT_EQ(five.islands.at_work(), (std::vector<int>{4}));
  EXPECT_TRUE(five.islands.is_settled(1));
  five.islands.widen();
  EXPECT_EQ(five.islands.at_work(), (std::vector<int>{1, 4}));
  EXPECT_FALSE(five.islands.is_settled(1));
  EXPECT_TRUE(five.islands.is_settled(0));
}



TEST(SettledIslands, block_that_flies_does_not_change_what_hits)
{
  int        alone_iterations = 0, iterations = 0;
  const Vec2 alone = fall(false, alone_iterations), beside = fall(true, iterations);
  EXPECT_GT(alone.norm(), 5e-4);
  EXPECT_GT(alone_iterations, 100); // the column hits the base
  EXPECT_NEAR((alone - beside).norm(), 0., 1e-9);
}
