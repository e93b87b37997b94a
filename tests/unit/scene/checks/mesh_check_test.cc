// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/bedrock/rigid_bedrock.h>
#include <hybrid/scene/checks/mesh_check.h>

#include "temporary_files.h"

#include <utility>

namespace hybrid::scene::test
{
  namespace
  {
    /// Two unit squares of bedrock, (0..2) x (0..1), under two triangular blocks that fill the unit
    /// square above the first.
    SectionMesh small_section()
    {
      SectionMesh mesh;
      mesh.nodes = {{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1., 1.}, {2., 1.}, {0., 2.}, {1., 2.}};
      mesh.bedrock_cells            = {{0, 1, 4, 3}, {1, 2, 5, 4}};
      mesh.bedrock_region           = {0, 0};
      mesh.bedrock_region_names     = {"bedrock"};
      mesh.blocks                   = {{3, 4, 7}, {3, 7, 6}};
      mesh.block_region             = {0, 0};
      mesh.block_region_names       = {"sliding_mass"};
      mesh.lines["base"]            = {{0, 1}, {1, 2}};
      mesh.lines["left"]            = {{0, 3}};
      mesh.lines["right"]           = {{2, 5}};
      mesh.lines["ground"]          = {{4, 5}};
      mesh.lines["sliding_surface"] = {{3, 4}};
      return mesh;
    }


    std::string mesh_error(const SectionMesh &mesh, const SceneParameters &scene = {})
    {
      return message_of([&]() { check_section_mesh(mesh, scene); });
    }
  } // namespace


  TEST(MeshCheck, SoundSectionPasses)
  {
    EXPECT_NO_THROW(check_section_mesh(small_section(), SceneParameters()));
  }


  TEST(MeshCheck, MissingGroupsAreNamed)
  {
    for (const char *const name : {"base", "left", "right", "sliding_surface"})
      {
        SectionMesh mesh = small_section();
        mesh.lines.erase(name);
        expect_part(mesh_error(mesh), std::string("no curve group '") + name + "'");
      }
    SectionMesh mesh = small_section();
    mesh.blocks.clear();
    expect_part(mesh_error(mesh), "no surface group 'sliding_mass'");
    mesh = small_section();
    mesh.bedrock_cells.clear();
    expect_part(mesh_error(mesh), "no surface group 'bedrock'");

    SceneParameters scene;
    scene.bedding.names = {"bedding_1"};
    expect_part(mesh_error(small_section(), scene),
                "no curve group 'bedding_1', which the section Bedding planes needs");
  }


  TEST(MeshCheck, OnlyWhatTheSceneUsesIsNeeded)
  {
    SectionMesh     mesh = small_section();
    SceneParameters scene;
    mesh.bedrock_cells.clear();
    mesh.lines.clear();
    scene.bedrock = rigid_bedrock();
    EXPECT_NO_THROW(check_section_mesh(mesh, scene));

    mesh = small_section();
    mesh.blocks.clear();
    scene                = SceneParameters();
    scene.blocks.enabled = false;
    EXPECT_NO_THROW(check_section_mesh(mesh, scene));
  }


  TEST(MeshCheck, InvertedCellsAndFlatBlocksAreFound)
  {
    SectionMesh mesh = small_section();
    std::swap(mesh.bedrock_cells[1][1], mesh.bedrock_cells[1][3]); // clockwise
    expect_part(mesh_error(mesh), "The bedrock cell at (1, 0) m is inverted or has no area");

    mesh          = small_section();
    mesh.nodes[5] = Vec2(1.4, 0.4); // a concave quadrilateral
    expect_part(mesh_error(mesh), "The bedrock cell at (1.4, 0.4) m");

    mesh          = small_section();
    mesh.nodes[6] = Vec2(0.5, 1.5); // on the line 3-7
    expect_part(mesh_error(mesh), "The block at (0, 1) m is inverted or has no area");
  }


  TEST(MeshCheck, ASliverOfOneDegreeIsABlock)
  {
    SectionMesh mesh = small_section();
    mesh.nodes[6]    = Vec2(0.5, 1.5) + Vec2(-0.5, 0.5) * 0.0175;
    EXPECT_NO_THROW(check_section_mesh(mesh, SceneParameters()));
  }


  TEST(MeshCheck, LinesThatAreInterchangedAreFound)
  {
    SectionMesh mesh = small_section();
    std::swap(mesh.lines["left"], mesh.lines["right"]);
    expect_part(mesh_error(mesh),
                "The line left, centred at (2, 0.5) m, does not bound the bedrock on the left");
    mesh = small_section();
    std::swap(mesh.lines["left"], mesh.lines["base"]);
    expect_part(mesh_error(mesh),
                "The line base, centred at (0, 0.5) m, does not bound the bedrock below");
    mesh                 = small_section();
    mesh.lines["base"]   = {{4, 5}};
    mesh.lines["ground"] = {{0, 1}, {1, 2}};
    expect_part(mesh_error(mesh),
                "The line base, centred at (1.5, 1) m, does not bound the bedrock below");
  }


  TEST(MeshCheck, RegionsOfTheTableMustBeInTheMesh)
  {
    SceneParameters scene;
    scene.continuum.region_material = "rock";
    EXPECT_NO_THROW(check_section_mesh(small_section(), scene));
    scene.continuum.region_material = RegionMaterials::parse("bedrock: rock; bedrok_2: rock");
    expect_part(mesh_error(small_section(), scene),
                "the mesh has no region 'bedrok_2'; it has bedrock");
    scene.continuum.region_material = "rock";
    scene.blocks.saturated_material = RegionMaterials::parse("sliding_mass_wet: rock");
    expect_part(
      mesh_error(small_section(), scene),
      "Blocks/Saturated material: the mesh has no region 'sliding_mass_wet'; it has sliding_mass");
    scene.blocks.enabled = false;
    EXPECT_NO_THROW(check_section_mesh(small_section(), scene));
  }


  TEST(MeshCheck, JointsRunAlongEdgesOfBlocks)
  {
    SceneParameters scene;
    SectionMesh     mesh  = small_section();
    mesh.lines["joint_a"] = {{7, 3}};
    EXPECT_NO_THROW(check_section_mesh(mesh, scene));
    scene.blocks.joint_materials = "clay";
    EXPECT_NO_THROW(check_section_mesh(mesh, scene));
    scene.blocks.joint_materials = RegionMaterials::parse("joint_b: clay");
    expect_part(mesh_error(mesh, scene),
                "Blocks/Joint materials: the mesh has no line 'joint_b'; it has joint_a");
    scene.blocks.joint_materials = "clay";
    expect_part(mesh_error(small_section(), scene), "the mesh has no line joint_<suffix>");
    mesh.lines["joint_a"] = {{1, 4}};
    expect_part(mesh_error(mesh, scene),
                "The line joint_a at (1, 0.5) m must run along edges of blocks of the sliding");
  }


  TEST(MeshCheck, BoundaryEdgesNeedALine)
  {
    SectionMesh mesh = small_section();
    mesh.lines.erase("ground");
    expect_part(mesh_error(mesh),
                "The boundary edge of the bedrock at (1.5, 1) m is on none of the lines");

    mesh = small_section();
    mesh.lines["ground"].push_back({2, 5});
    expect_part(mesh_error(mesh), "at (2, 0.5) m is on two lines, ground and right");

    mesh = small_section();
    mesh.lines["ground"].push_back({1, 4});
    expect_part(mesh_error(mesh),
                "The line ground at (1, 0.5) m must run along cell edges on the boundary");

    mesh                    = small_section();
    mesh.lines["bedding_1"] = {{1, 4}};
    EXPECT_NO_THROW(check_section_mesh(mesh, SceneParameters()));
    mesh.lines["bedding_1"] = {{0, 1}};
    expect_part(mesh_error(mesh),
                "The line bedding_1 at (0.5, 0) m must run along cell edges inside");
  }


  TEST(MeshCheck, SeparateNodesOnTheSlidingSurfaceAreFound)
  {
    SectionMesh mesh = small_section();
    mesh.nodes.push_back(mesh.nodes[4]);
    mesh.blocks[0][1] = 8;
    expect_part(mesh_error(mesh), "separate nodes on the sliding surface at (1, 1) m");

    SceneParameters scene;
    scene.mesh.polygons_file = "blocks.csv"; // blocks that merely rest on the surface
    EXPECT_NO_THROW(check_section_mesh(mesh, scene));
  }
} // namespace hybrid::scene::test
