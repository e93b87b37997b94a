// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/joint_line_warnings.h>

#include <gtest/gtest.h>

#include "expect_warning.h"

namespace hybrid::scene
{
  namespace
  {
    /// A long block from (0, 0) to (10, 1), and a square on it at x = 4 to 5, with its own nodes.
    class JointLineWarnings : public testing::Test
    {
    protected:
      SectionMesh     mesh;
      SceneParameters scene;

      void SetUp() override
      {
        mesh.nodes = {
          {0., 0.}, {10., 0.}, {10., 1.}, {0., 1.}, {4., 1.}, {5., 1.}, {5., 2.}, {4., 2.}};
        mesh.blocks = {{0, 1, 2, 3}, {4, 5, 6, 7}};
        Material clay;
        clay.name                    = "clay";
        scene.materials["clay"]      = clay;
        scene.blocks.joint_materials = RegionMaterials::parse("joint_x: clay");
      }

      void expect(const std::vector<std::string> &words) const
      {
        hybrid::test::expect_warning(joint_line_warnings(mesh, scene), words);
      }
    };
  } // namespace


  TEST_F(JointLineWarnings, EdgesNamedOnBothSidesOrShared)
  {
    mesh.lines["joint_x"] = {{4, 5}, {3, 2}};
    expect({});
    mesh.blocks.push_back({7, 6, 5}); // shares an edge of the square
    mesh.lines["joint_x"] = {{5, 6}};
    expect({});
  }


  TEST_F(JointLineWarnings, AnEdgeNamedOnOneSide)
  {
    mesh.lines["joint_x"] = {{4, 5}};
    expect({"joint_x: at 1 of its 1 edge, the first at (4.5, 1)", "name both"});
    mesh.lines["joint_x"] = {{2, 3}};
    expect({"joint_x: at 1 of its 1 edge, the first at (5, 1)"});
    mesh.lines["joint_y"] = {{4, 5}}; // another name does not do
    expect({"joint_x: at 1 of its 1 edge"});
  }


  TEST_F(JointLineWarnings, AnEdgeAtNoOtherBlock)
  {
    mesh.lines["joint_x"] = {{0, 1}, {4, 5}, {2, 3}};
    expect({"joint_x: no other block lies at 1 of its 3 edges, the first at (5, 0)"});
    mesh.lines["joint_x"] = {{6, 7}};
    expect({"joint_x: no other block lies at 1 of its 1 edge"});
  }
} // namespace hybrid::scene
