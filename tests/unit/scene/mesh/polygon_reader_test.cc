// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/polygon_reader.h>
#include <hybrid/scene/mesh/section_mesh_reader.h>

#include "temporary_files.h"

namespace hybrid::scene::test
{
  namespace
  {
    class PolygonReader : public TemporaryFiles
    {
    protected:
      SectionMesh polygons(const std::string &text) const
      {
        SectionMesh mesh;
        read_polygons(write("blocks.csv", text), mesh);
        return mesh;
      }

      std::string polygon_error(const std::string &text) const
      {
        return message_of([&]() { polygons(text); });
      }

      std::string surface_error(const std::string &text) const
      {
        SectionMesh mesh;
        return message_of([&]() { read_surface(write("surface.csv", text), mesh); });
      }
    };
  } // namespace


  TEST_F(PolygonReader, BlocksShareNodes)
  {
    const SectionMesh mesh = polygons(
      "block,x,y,region\n"
      "# counter-clockwise both\n"
      "a,0,0\na,2,0\na,2,1\na,0,1\n\n"
      "b,2,0,sliding_mass_top\nb,4,0,sliding_mass_top\nb,2,1,sliding_mass_top # a triangle\n");
    ASSERT_EQ(mesh.blocks.size(), 2u);
    EXPECT_EQ(mesh.nodes.size(), 5u); // two are shared
    EXPECT_EQ(mesh.blocks[0], (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(mesh.blocks[1], (std::vector<int>{1, 4, 2}));
    EXPECT_EQ(mesh.block_region, (std::vector<int>{0, 1}));
    EXPECT_EQ(mesh.block_region_names,
              (std::vector<std::string>{"sliding_mass", "sliding_mass_top"}));
  }


  TEST_F(PolygonReader, EdgesAreOnTheJointOfTheirFirstVertex)
  {
    const std::string left = "a,0,0\na,1,0,,joint_steep\na,1,1\na,0,1\n";
    SectionMesh       mesh =
      polygons(left + "b,1,0,sliding_mass,joint_flat\nb,2,0\nb,2,1\nb,1,1,,joint_steep\n");
    ASSERT_EQ(mesh.lines.size(), 2u);
    EXPECT_EQ(mesh.lines.at("joint_steep"), (std::vector<SectionMesh::Edge>{{1, 2}})); // once
    EXPECT_EQ(mesh.lines.at("joint_flat"), (std::vector<SectionMesh::Edge>{{1, 4}}));
    read_polygons(write("others.csv", "a,0,0\na,1,0\na,1,1\n"), mesh);
    EXPECT_TRUE(mesh.lines.empty());
    expect_part(polygon_error("a,0,0\na,1,0,,steep\na,1,1\n"),
                "blocks.csv:2: the joint 'steep' is not allowed; it must be joint_<suffix>");
  }


  // 0.1 + 0.2 is not 0.3 in the last digit; 0.001 m is no rounding.
  TEST_F(PolygonReader, RoundedCornersAreOneNode)
  {
    const std::string left = "a,0,0\na,0.3,0\na,0.3,1\na,0,1\n";
    EXPECT_EQ(
      polygons(left + "b,0.30000000000000004,0\nb,1,0\nb,1,1\nb,0.2999999999,1\n").nodes.size(),
      6u);
    EXPECT_EQ(polygons(left + "b,0.301,0\nb,1,0\nb,1,1\nb,0.301,1\n").nodes.size(), 8u);
    // However small a block elsewhere is.
    const std::string right = "b,0.3000001,0\nb,1,0\nb,1,1\nb,0.3,1\n";
    EXPECT_EQ(polygons(left + right).nodes.size(), 6u);
    EXPECT_EQ(polygons("s,5,0\ns,5.001,0\ns,5,0.001\n" + left + right).nodes.size(), 9u);
  }


  TEST_F(PolygonReader, MessagesCallBlocksAsTheFileDoes)
  {
    const SectionMesh mesh = polygons("7,0,0\n7,1,0\n7,0,1\ntop,0,1\ntop,1,1\ntop,0,2\n");
    EXPECT_EQ(mesh.block_name(0), "7");
    EXPECT_EQ(mesh.block_name(1), "top");
    EXPECT_EQ(SectionMesh().block_name(3), "3"); // of a mesh: its number
  }



  TEST_F(PolygonReader, ConcavePolygonsAndStraightAnglesAreAllowed)
  {
    const SectionMesh mesh = polygons("L,0,0\nL,1,0\nL,2,0\nL,2,1\nL,1,1\nL,1,2\nL,0,2\n");
    EXPECT_EQ(mesh.blocks[0].size(), 7u);
  }


  TEST_F(PolygonReader, BadPolygonsAreRefusedWithTheirLine)
  {
    expect_part(polygon_error("a,0,0\na,1,0\n"), "blocks.csv:1: block a has 2 vertices");
    expect_part(polygon_error("a,0,0\na,1,0\na,1,0\na,0,1\n"),
                "blocks.csv:3: block a repeats the vertex of line 2");
    expect_part(polygon_error("a,0,0\na,1,0\na,1,1\na,0,0\n"), "repeats the vertex");
    expect_part(polygon_error("a,0,0\na,1,1\na,1,0\na,0,1\n"),
                "edges that start in line 1 at (0, 0) m and in line 3 at (1, 0) m meet"); // bow tie
    expect_part(polygon_error("a,0,0\na,2,0\na,1,0\n"),
                "folds back on itself (zero area) at (2, 0) m");
    expect_part(polygon_error("a,0,2\na,0,3\na,1,3\na,1,2\n"),
                "blocks.csv:1: block a runs clockwise from its first vertex at (0, 2) m");
    expect_part(polygon_error("a,0,0\na,4,0\na,4,4\na,2,0\na,0,4\n"),
                "not a simple polygon"); // touches itself
    expect_part(polygon_error("a,0,0\na,1,zero\na,0,1\n"),
                "blocks.csv:2: 'zero' is not a number; expected y [m]");
    expect_part(polygon_error("a,0\n"), "blocks.csv:1: found 2 columns");
    expect_part(polygon_error("a,0,0,bedrock\n"), "region 'bedrock' is not allowed");
    expect_part(polygon_error("a,0,0\na,1,0,sliding_mass_b\n"), "block a is in two regions");
    expect_part(polygon_error("a,0,0\nb,1,0\na,0,1\n"),
                "blocks.csv:3: the rows of block a do not follow each other");
    expect_part(polygon_error("# nothing\n"), "the file has no block");
    expect_part(
      polygon_error("block,y,x\na,0,0\na,1,0\na,0,1\n"),
      "blocks.csv:1: the heading names 'y' as column 2; the order of the columns is block, x, y");
  }


  TEST_F(PolygonReader, SurfaceIsAPolylineFromLeftToRight)
  {
    SectionMesh mesh;
    read_surface(write("surface.csv", "x,y\n-10,5\n0,0\n0,-1\n20,0\n"), mesh);
    EXPECT_EQ(mesh.nodes, (std::vector<Vec2>{{-10., 5.}, {0., 0.}, {0., -1.}, {20., 0.}}));
    EXPECT_EQ(mesh.lines.at("sliding_surface"),
              (std::vector<SectionMesh::Edge>{{0, 1}, {1, 2}, {2, 3}}));

    expect_part(
      surface_error("Y [m], X [m]\n5,-10\n0,0\n"),
      "surface.csv:1: the heading names 'Y [m]' as column 1; the order of the columns is x, y");
    expect_part(surface_error("0,0\n"), "found 1 point;");
    expect_part(surface_error("0,0\n1,0\n0.5,0\n"),
                "surface.csv:3: x = 0.5 is left of the point before");
    expect_part(surface_error("0,0\n1,0\n1,0\n"), "surface.csv:3: the point is the same");
    expect_part(surface_error("0,0,0\n1,0,0\n"), "surface.csv:1: found 3 columns");
    expect_part(surface_error("0,0\n1,0\n1,8\n1,-8\n9,0\n"),
                "surface.csv:4: the surface folds back on itself at (1, 8) m");
  }


  TEST_F(PolygonReader, FilesReplaceBlocksAndSurfaceOfAMesh)
  {
    MeshParameters parameters;
    parameters.file          = std::string(HYBRID_SOURCE_DIR) + "/meshes/half_blocks.geo";
    parameters.polygons_file = write("blocks.csv", "a,0,50\na,10,50\na,0,60\n");
    const SectionMesh mesh   = read_section_mesh(parameters);
    EXPECT_EQ(mesh.blocks.size(), 1u);
    EXPECT_EQ(mesh.bedrock_cells.size(), 20u);
    EXPECT_EQ(mesh.nodes.size(),
              33u + 3u); // the old blocks' own nodes are gone, the new block's are its own
    EXPECT_EQ(mesh.lines.count("mass_surface"), 0u);
    EXPECT_EQ(mesh.lines.at("sliding_surface").size(), 2u);
  }


  TEST_F(PolygonReader, SceneWithoutMeshFile)
  {
    MeshParameters parameters;
    parameters.polygons_file = write("blocks.csv", "a,0,0\na,1,0\na,0,1\n");
    parameters.surface_file  = write("surface.csv", "-5,0\n5,0\n");
    const SectionMesh mesh   = read_section_mesh(parameters);
    EXPECT_EQ(mesh.blocks.size(), 1u);
    EXPECT_EQ(mesh.lines.at("sliding_surface").size(), 1u);
    EXPECT_TRUE(mesh.bedrock_cells.empty());
    EXPECT_EQ(mesh.nodes.size(), 5u);
  }
} // namespace hybrid::scene::test
