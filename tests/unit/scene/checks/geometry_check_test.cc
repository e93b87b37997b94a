// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/geometry_check.h>

#include "rigid_scene.h"
#include "temporary_files.h"

namespace hybrid::scene::test
{
  namespace
  {
    /// Four unit squares of bedrock, (0..2) x (0..2), under a square block above the first column.
    SectionMesh small_section()
    {
      SectionMesh mesh;
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
          mesh.nodes.emplace_back(column, row);
      mesh.nodes.emplace_back(1., 3.);
      mesh.nodes.emplace_back(0., 3.);
      mesh.bedrock_cells            = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}};
      mesh.bedrock_region           = {0, 0, 0, 0};
      mesh.bedrock_region_names     = {"bedrock"};
      mesh.blocks                   = {{6, 7, 9, 10}};
      mesh.block_region             = {0};
      mesh.block_region_names       = {"sliding_mass"};
      mesh.lines["sliding_surface"] = {{6, 7}};
      mesh.lines["ground"]          = {{7, 8}};
      return mesh;
    }


    void add_block(SectionMesh &mesh, const std::vector<Vec2> &vertices)
    {
      std::vector<int> block;
      for (const Vec2 &x : vertices)
        {
          block.push_back(mesh.nodes.size());
          mesh.nodes.push_back(x);
        }
      mesh.blocks.push_back(block);
      mesh.block_region.push_back(0);
    }


    std::string geometry_error(const SectionMesh &mesh, const SceneParameters &scene = {})
    {
      return message_of([&]() { check_geometry(mesh, scene); });
    }
  } // namespace


  TEST(GeometryCheck, ACompliantBaseIsLevel)
  {
    SectionMesh     mesh  = small_section();
    SceneParameters scene = SceneParameters();
    mesh.lines["base"]    = {{0, 1}, {1, 2}};
    scene.motion.type     = "sine";
    ASSERT_TRUE(scene.continuum.base.is_compliant && scene.continuum.base.takes_motion);
    EXPECT_NO_THROW(check_geometry(mesh, scene));
    mesh.nodes[1].y() = -0.1;
    expect_part(geometry_error(mesh, scene), "needs a level base");
    expect_part(geometry_error(mesh, scene), "between y = -0.1 and 0 m");
    mesh.lines["base"] = {{0, 3}, {3, 6}}; // of a bar that lies
    EXPECT_NO_THROW(check_geometry(mesh, scene));
    mesh.lines["base"] = {{0, 1}, {1, 2}};
    scene.motion.type  = "none"; // it only absorbs
    EXPECT_NO_THROW(check_geometry(mesh, scene));
  }


  TEST(GeometryCheck, SoundSectionPasses)
  {
    SectionMesh mesh = small_section();
    EXPECT_NO_THROW(check_geometry(mesh, SceneParameters()));
    add_block(mesh, {{1., 2.}, {2., 2.}, {2., 3.}, {1., 3.}}); // beside the first, on the ground
    EXPECT_NO_THROW(check_geometry(mesh, SceneParameters()));
    mesh.nodes[11].x() = 0.9999; // rounded coordinates
    EXPECT_NO_THROW(check_geometry(mesh, SceneParameters()));
  }


  TEST(GeometryCheck, OverlappingBlocksAreNamedWithTheirCentres)
  {
    const std::vector<std::vector<Vec2>> overlapping = {
      {{0.5, 2.}, {1.5, 2.}, {1.5, 3.}, {0.5, 3.}},                          // same top and bottom
      {{0., 2.}, {1., 2.}, {1., 3.}, {0., 3.}},                              // the same block
      {{0.4, 2.4}, {0.6, 2.4}, {0.6, 2.6}, {0.4, 2.6}},                      // within it
      {{-1., 2.4}, {2., 2.4}, {2., 2.6}, {-1., 2.6}},                        // a cross
      {{0.5, 4.}, {0.5, 2.5}, {0.7, 3.5}, {2., 4.}},                         // a hook's point
      {{-1., 2.}, {0.1, 2.}, {0.1, 3.}, {-1., 3.}, {-1., 2.8}, {-0.5, 2.5}}, // not convex
    };
    for (const auto &vertices : overlapping)
      {
        SectionMesh mesh = small_section();
        add_block(mesh, vertices);
        const std::string message = geometry_error(mesh);
        expect_part(message, "(0.5, 2.5) m");
        expect_part(message, " overlaps the block at ");
      }
  }


  TEST(GeometryCheck, ANotchMayHoldABlock)
  {
    SectionMesh mesh = small_section();
    add_block(mesh,
              {{-1., 2.}, {0., 2.}, {0., 3.}, {1., 3.}, {1., 2.}, {2., 2.}, {2., 4.}, {-1., 4.}});
    SceneParameters scene = rigid_scene();
    mesh.lines.clear();
    EXPECT_NO_THROW(check_geometry(mesh, scene));
    mesh.nodes[9].x() = mesh.nodes[7].x() = 1.1; // into the arch's leg
    expect_part(geometry_error(mesh, scene), "overlaps the block at");
  }


  TEST(GeometryCheck, BlocksInsideTheRockAreFound)
  {
    SectionMesh mesh = small_section();
    add_block(mesh, {{1.2, 1.8}, {1.8, 1.8}, {1.8, 2.8}, {1.2, 2.8}});
    expect_part(geometry_error(mesh),
                "The block at (1.5, 2.3) m lies inside the bedrock, in its cell at (1.5, 1.5) m.");
  }


  TEST(GeometryCheck, ABlockAtTheFootOfAWallIsNotBelowTheLedgeOnTop)
  {
    SectionMesh mesh = small_section();
    mesh.lines       = {};
    mesh.blocks      = {};
    const auto first = static_cast<int>(mesh.nodes.size());
    const auto base  = {Vec2(-2., 2.), Vec2(0., 2.), Vec2(0., 0.), Vec2(3., 0.)};
    mesh.nodes.insert(mesh.nodes.end(), base.begin(), base.end());
    mesh.lines["ground"] = {{first, first + 1}, {first + 1, first + 2}, {first + 2, first + 3}};
    add_block(mesh, {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}});
    EXPECT_NO_THROW(check_geometry(mesh, rigid_scene()));
    mesh.nodes[mesh.blocks[0][0]] = Vec2(-0.2, 0.1); // into the wall
    expect_part(geometry_error(mesh, rigid_scene()),
                "has its vertex (-0.2, 0.1) m below the base.");
  }


  TEST(GeometryCheck, BlocksUnderARigidBaseAreFound)
  {
    SectionMesh mesh = small_section();
    EXPECT_NO_THROW(check_geometry(mesh, rigid_scene()));
    add_block(mesh, {{1.2, 1.9}, {1.8, 2.}, {1.8, 2.8}, {1.2, 2.8}});
    expect_part(geometry_error(mesh, rigid_scene()),
                "The block at (1.5, 2.375) m has its vertex (1.2, 1.9) m below the base.");

    mesh              = small_section();
    mesh.nodes[7]     = Vec2(1., 2.5); // a peak of the base
    mesh.blocks[0]    = {6, 8, 9, 10};
    mesh.nodes[9].x() = 2.;
    expect_part(geometry_error(mesh, rigid_scene()),
                "has the point of the base at (1, 2.5) m inside");
  }


  TEST(GeometryCheck, GapsAtTheSlidingSurfaceAreFound)
  {
    SectionMesh mesh = small_section();
    mesh.lines["sliding_surface"].push_back({7, 8});
    expect_part(geometry_error(mesh), "There is a gap above the sliding surface at (1.5, 2) m");
    SceneParameters scene;
    scene.mesh.polygons_file = "blocks.csv"; // blocks that merely lie on it
    EXPECT_NO_THROW(check_geometry(mesh, scene));
  }


  TEST(GeometryCheck, BedrockIsOnePiece)
  {
    SectionMesh mesh   = small_section();
    mesh.bedrock_cells = {{0, 1, 4, 3}, {4, 5, 8, 7}}; // a hinge
    mesh.blocks.clear();
    expect_part(geometry_error(mesh), "its cells at (0, 0) m and (1, 1) m are not connected");
  }


  TEST(GeometryCheck, BeddingPlanesThatCrossAreNamed)
  {
    SectionMesh mesh        = small_section();
    mesh.lines["bedding_1"] = {{3, 4}, {4, 5}};
    mesh.lines["bedding_2"] = {{1, 4}};
    EXPECT_NO_THROW(check_geometry(mesh, SceneParameters())); // it ends there
    mesh.lines["bedding_2"].push_back({4, 7});
    expect_part(geometry_error(mesh),
                "The bedding planes bedding_1 and bedding_2 cross at (1, 1) m");
  }


  TEST(GeometryCheck, ARigidBaseIsOnePolyline)
  {
    SectionMesh mesh = small_section();
    mesh.nodes.emplace_back(3., 2.);
    mesh.nodes.emplace_back(4., 2.);
    mesh.lines["ground"].push_back({11, 12});
    expect_part(geometry_error(mesh, rigid_scene()),
                "The base has a gap between (2, 2) m and (3, 2) m");
    mesh.lines["ground"].push_back({8, 11});
    EXPECT_NO_THROW(check_geometry(mesh, rigid_scene()));
  }
} // namespace hybrid::scene::test
