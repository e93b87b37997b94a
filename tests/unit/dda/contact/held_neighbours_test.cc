// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/contact/held_neighbours.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  using Lists = std::vector<std::vector<int>>;

  /// Four squares around node 4.
  const Lists four_squares{{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}};
} // namespace



TEST(HeldNeighbours, are_held_across_a_corner_by_the_blocks_between_them)
{
  const Lists held = held_neighbours(four_squares, {{0, 1}, {0, 2}, {1, 3}, {2, 3}});
  EXPECT_EQ(held, (Lists{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}));
}



TEST(HeldNeighbours, are_not_held_where_no_joint_leads_around_the_node)
{
  EXPECT_EQ(held_neighbours(four_squares, {}), Lists(4));
  // 0 and 1 are bonded, 2 and 3 too, but not the pairs above each other.
  EXPECT_EQ(held_neighbours(four_squares, {{0, 1}, {2, 3}}), (Lists{{1}, {0}, {3}, {2}}));
}



TEST(HeldNeighbours, must_be_held_at_every_shared_node)
{
  // 0 and 1 share nodes 1 and 4: the blocks 2 and 3 lead around node 4 only.
  const Lists held = held_neighbours(four_squares, {{0, 2}, {1, 3}, {2, 3}});
  EXPECT_EQ(held[0], (std::vector<int>{2, 3}));
  EXPECT_EQ(held[1], (std::vector<int>{2, 3}));
}



TEST(HeldNeighbours, loose_blocks_on_a_belt_have_none)
{
  scene::SceneParameters p      = block_parameters(30.);
  p.blocks.belt_material        = "belt";
  p.materials["belt"]           = p.materials["rock"];
  scene::SectionMesh mesh       = square_blocks(2, 1);
  mesh.lines["sliding_surface"] = {{0, 1}, {1, 2}};
  const Model model             = build_model(mesh, p, straight_foundation(0., 0., 2., 2));
  ASSERT_FALSE(model.joints.empty());
  EXPECT_TRUE(model.neighbours[0].empty());
}
