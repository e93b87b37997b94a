// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/element_space.h>

#include "rectangle_mesh.h"

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  /// A slanting section of 3 x 2 cells.
  struct Rock
  {
    scene::SectionMesh section =
      test::rectangle_mesh(test::equal_spacing(0., 30., 3), test::equal_spacing(0., 10., 2));
    RockMesh     rock;
    ElementSpace space;

    Rock()
      : rock(split_bedding_planes(slanting(section), {}))
      , space(rock, section, 3, MPI_COMM_SELF)
    {}

    static const scene::SectionMesh &slanting(scene::SectionMesh &mesh)
    {
      for (Vec2 &node : mesh.nodes)
        node += Vec2(0.3 * node.y(), 0.01 * node.x() * node.y());
      return mesh;
    }
  };
} // namespace



TEST(ElementNodes, map_brings_local_nodes_to_their_positions)
{
  const Rock          f;
  const ElementNodes &nodes = f.space.nodes;
  const auto         &x     = nodes.line.nodes();
  for (std::size_t c = 0; c < nodes.cells.size(); ++c)
    for (std::size_t k = 0; k < nodes.cells[c].size(); ++k)
      {
        const Vec2 local(x[k % 4], x[k / 4]);
        EXPECT_LT(
          (nodes.map(static_cast<int>(c), local) - nodes.position(nodes.cells[c][k])).norm(),
          1e-13);
      }
}



TEST(ElementNodes, what_is_kept_of_them_stays_as_it_was)
{
  const Rock         f;
  const ElementNodes before = f.space.nodes;
  ElementNodes       nodes  = before;
  const std::size_t  n      = nodes.size();
  nodes.keep_positions({n / 3, n / 2});
  nodes.keep_cells([](const std::size_t cell) { return cell % 2 == 1; });
  EXPECT_EQ(static_cast<std::size_t>(nodes.size()), n);
  EXPECT_EQ(nodes.positions.size(), n / 2 - n / 3);
  for (std::size_t node = n / 3; node < n / 2; ++node)
    EXPECT_EQ(nodes.position(static_cast<int>(node)), before.positions[node]);
  ASSERT_EQ(nodes.cells.size(), before.cells.size());
  for (std::size_t c = 0; c < nodes.cells.size(); ++c)
    {
      EXPECT_EQ(nodes.cells[c], c % 2 == 1 ? before.cells[c] : std::vector<int>());
      const Vec2 local(0.3, 0.9);
      EXPECT_EQ(nodes.map(static_cast<int>(c), local), before.map(static_cast<int>(c), local));
      EXPECT_EQ(nodes.jacobian(static_cast<int>(c), local),
                before.jacobian(static_cast<int>(c), local));
    }
}
