// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/geometry_warnings.h>

#include <gtest/gtest.h>

#include "expect_warning.h"

namespace hybrid::scene
{
  namespace
  {
    class GeometryWarnings : public testing::Test
    {
    protected:
      SectionMesh     mesh;
      SceneParameters scene;

      /// A base from (0, 0) to (10, 0) in two edges, a unit square on it and another on that.
      void SetUp() override
      {
        scene.blocks.bonded           = false;
        mesh.nodes                    = {{0., 0.}, {4., 0.}, {10., 0.}};
        mesh.lines["sliding_surface"] = {{0, 1}, {1, 2}};
        add_block({{1., 0.}, {2., 0.}, {2., 1.}, {1., 1.}});
        add_block({{1.5, 1.}, {2.5, 1.}, {2.5, 2.}, {1.5, 2.}});
      }

      void add_block(const std::vector<Vec2> &vertices)
      {
        std::vector<int> block;
        for (const Vec2 &x : vertices)
          {
            block.push_back(mesh.nodes.size());
            mesh.nodes.push_back(x);
          }
        mesh.blocks.push_back(block);
      }

      void expect(const std::vector<std::string> &words) const
      {
        hybrid::test::expect_warning(geometry_warnings(mesh, scene), words);
      }
    };
  } // namespace


  TEST_F(GeometryWarnings, BlocksOnTheBaseAndOnEachOtherAreHeld)
  {
    expect({});
    for (const int node : mesh.blocks[1])
      mesh.nodes[node].y() += 5e-4; // rounded
    expect({});
  }


  TEST_F(GeometryWarnings, AGapIsNamedWithItsPlaceAndWidth)
  {
    for (const int node : mesh.blocks[1])
      mesh.nodes[node].y() += 0.25;
    add_block({{1.5, 2.25}, {2.5, 2.25}, {2.5, 3.}, {1.5, 3.}}); // on the one that hangs
    expect({"2 blocks with nothing below", "(1.5, 1.25) m", "0.25 m are between"});
    scene.environment.static_stage = StaticStage::none; // they are to fall
    expect({});
    scene.environment.static_stage = StaticStage::equilibrium;
    scene.environment.gravity      = 0.;
    expect({});
  }


  TEST_F(GeometryWarnings, AMassBesideOrWithoutABaseIsNamed)
  {
    add_block({{12., 0.}, {13., 0.}, {13., 1.}, {12., 1.}});
    expect({"a block with nothing below", "(12, 0) m", "2 m are between"});
    mesh.lines.clear();
    expect({"3 blocks", "there is no base"});
  }


  TEST_F(GeometryWarnings, CornersThatAreNearlyInOnePlaceAreNamed)
  {
    add_block({{2.0005, 0.}, {3., 0.}, {3., 0.5}, {2.001, 0.5}});
    expect({});
    scene.blocks.bonded = true;
    mesh.blocks.erase(mesh.blocks.begin() + 1); // which lies along half an edge
    expect({"next to each other", "0.0005 m apart at (2, 0) m;", "not bonded"});
  }


  TEST_F(GeometryWarnings, TheEndsOfAShortEdgeAreNoNearCorners)
  {
    scene.blocks.bonded = true;
    mesh.blocks.erase(mesh.blocks.begin() + 1);
    add_block({{5., 0.}, {6., 0.}, {6., 0.9995}, {5.9995, 1.}, {5., 1.}});
    expect({});
  }


  TEST_F(GeometryWarnings, SliversAreNamed)
  {
    add_block({{5., 0.}, {9., 0.}, {9., 1e-3}, {5., 1e-3}});
    expect({"the block at (5, 0) m is a sliver, 4 m long and 0.001 m thick"});
  }


  TEST_F(GeometryWarnings, PolygonsThatYieldAreNamed)
  {
    scene.blocks.yielding = true;
    expect({"2 of 2 blocks that yield have more than three corners", "make them triangles"});
    mesh.blocks.clear();
    add_block({{1., 0.}, {2., 0.}, {1.5, 1.}});
    expect({});
  }


  TEST_F(GeometryWarnings, ASectionFarFromTheOriginIsNamed)
  {
    for (Vec2 &node : mesh.nodes)
      node.x() += 900.;
    expect({});
    for (Vec2 &node : mesh.nodes)
      node.x() += 99100.;
    expect({"100010 m from the origin and is 10.19804 m across"});
  }
} // namespace hybrid::scene
