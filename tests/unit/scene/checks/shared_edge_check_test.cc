// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/shared_edge_check.h>

#include <gtest/gtest.h>

#include <vector>

namespace hybrid::scene
{
  namespace
  {
    void add_block(SectionMesh &mesh, const std::vector<Vec2> &vertices)
    {
      std::vector<int> block;
      for (const Vec2 &x : vertices)
        {
          std::size_t n = 0;
          while (n < mesh.nodes.size() && mesh.nodes[n] != x)
            ++n;
          if (n == mesh.nodes.size())
            mesh.nodes.push_back(x);
          block.push_back(static_cast<int>(n));
        }
      mesh.blocks.push_back(block);
    }
  } // namespace


  TEST(SharedEdgeCheck, WholeEdgesAndCornersAreQuiet)
  {
    SectionMesh mesh;
    add_block(mesh, {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}});
    add_block(mesh, {{1., 0.}, {2., 0.}, {2., 1.}, {1., 1.}});
    add_block(mesh, {{2., 1.}, {3., 1.}, {3., 2.}, {2., 2.}}); // touches with a corner
    add_block(mesh, {{4., 0.}, {5., 0.}, {5., 1.}, {4., 1.}}); // on the same line, apart
    EXPECT_EQ(partly_shared_edges(mesh), "");
  }


  TEST(SharedEdgeCheck, BricksInRunningBondAreNamed)
  {
    SectionMesh mesh;
    add_block(mesh, {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}});
    add_block(mesh, {{1., 0.}, {2., 0.}, {2., 1.}, {1., 1.}});
    add_block(mesh, {{0.5, 1.}, {1.5, 1.}, {1.5, 2.}, {0.5, 2.}});
    const std::string text = partly_shared_edges(mesh);
    EXPECT_NE(text.find("coincide only in part"), std::string::npos) << text;
    EXPECT_NE(text.find(") m and in 1 other place: joints bond whole edges"), std::string::npos)
      << text;
    // With the corners of the bricks above and below all edges are whole.
    mesh.blocks = {};
    add_block(mesh, {{0., 0.}, {1., 0.}, {1., 1.}, {0.5, 1.}, {0., 1.}});
    add_block(mesh, {{1., 0.}, {2., 0.}, {2., 1.}, {1.5, 1.}, {1., 1.}});
    add_block(mesh, {{0.5, 1.}, {1., 1.}, {1.5, 1.}, {1.5, 2.}, {0.5, 2.}});
    EXPECT_EQ(partly_shared_edges(mesh), "");
  }
} // namespace hybrid::scene
