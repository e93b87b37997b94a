// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/bedrock/rigid_bedrock.h>
#include <hybrid/scene/checks/cavern_check.h>
#include <hybrid/scene/checks/mesh_check.h>

#include "temporary_files.h"

namespace hybrid::scene::test
{
  namespace
  {
    /// Nine unit squares, of which the middle one is not rock.
    SectionMesh section_with_cavern()
    {
      SectionMesh mesh;
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
          mesh.nodes.push_back({double(i), double(j)});
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          if (i != 1 || j != 1)
            {
              const int n = 4 * j + i;
              mesh.bedrock_cells.push_back({n, n + 1, n + 5, n + 4});
              mesh.bedrock_region.push_back(0);
            }
      mesh.bedrock_region_names = {"bedrock"};
      mesh.lines["base"]        = {{0, 1}, {1, 2}, {2, 3}};
      mesh.lines["left"]        = {{0, 4}, {4, 8}, {8, 12}};
      mesh.lines["right"]       = {{3, 7}, {7, 11}, {11, 15}};
      mesh.lines["ground"]      = {{12, 13}, {13, 14}, {14, 15}};
      return mesh;
    }


    void add_wall(SectionMesh &mesh)
    {
      for (const SectionMesh::Edge &edge : {SectionMesh::Edge{5, 6}, {6, 10}, {10, 9}, {9, 5}})
        mesh.lines["ground"].push_back(edge);
    }


    std::string error_of(const SectionMesh &mesh, const SceneParameters &scene)
    {
      return message_of([&]() { check_caverns(mesh, scene); });
    }
  } // namespace


  TEST(CavernCheck, WallOfACavernIsGround)
  {
    SceneParameters scene;
    scene.blocks.enabled = false;
    SectionMesh mesh     = section_with_cavern();
    expect_part(error_of(mesh, scene), "a closed cavern, x = 1 to 2 m, y = 1 to 2 m, whose wall");
    expect_part(error_of(mesh, scene), "belongs to the curve group 'ground'");
    expect_part(message_of([&]() { check_section_mesh(mesh, scene); }), "a closed cavern");
    add_wall(mesh);
    EXPECT_NO_THROW(check_section_mesh(mesh, scene));
  }


  TEST(CavernCheck, FiniteElementsBelowBlocksHaveNoCavern)
  {
    SceneParameters scene;
    SectionMesh     mesh = section_with_cavern();
    expect_part(error_of(mesh, scene), "must be one path from side to side");
    add_wall(mesh);
    expect_part(error_of(mesh, scene), "or set Model/Blocks = none");
  }


  TEST(CavernCheck, BoundaryOfAPieceOfRockIsNoCavern)
  {
    SceneParameters scene;
    SectionMesh     mesh = section_with_cavern();
    mesh.bedrock_cells.push_back({5, 6, 10, 9}); // fill it
    EXPECT_NO_THROW(check_caverns(mesh, scene));
    mesh.bedrock_cells.erase(mesh.bedrock_cells.begin() + 1); // a notch from below
    EXPECT_NO_THROW(check_caverns(mesh, scene));
  }
} // namespace hybrid::scene::test
