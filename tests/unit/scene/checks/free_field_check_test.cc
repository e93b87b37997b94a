// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_warning.h"

#include <hybrid/scene/bedrock/triangles_bedrock.h>
#include <hybrid/scene/boundary/fixed_base.h>
#include <hybrid/scene/boundary/fixed_side.h>
#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/roller_side.h>
#include <hybrid/scene/boundary/viscous_side.h>
#include <hybrid/scene/checks/free_field_check.h>

namespace hybrid::scene
{
  namespace
  {
    using hybrid::test::expect_warning;

    /// Bedrock whose ground goes from 100 m on the left over @p y [m] at x = 100 m to 100 m on the
    /// right, at x = 1000 m, and level over 400 m there.
    SectionMesh section(const double y)
    {
      SectionMesh mesh;
      mesh.nodes          = {{0., 0.},
                             {100., 0.},
                             {600., 0.},
                             {1000., 0.},
                             {0., 100.},
                             {100., y},
                             {600., 100.},
                             {1000., 100.}};
      mesh.bedrock_cells  = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}};
      mesh.lines["left"]  = {{0, 4}};
      mesh.lines["right"] = {{3, 7}};
      return mesh;
    }


    SceneParameters free_field()
    {
      SceneParameters scene;
      scene.continuum.sides = free_field_side();
      return scene;
    }


    TEST(FreeFieldCheck, LevelGroundBesideTheSidesPasses)
    {
      expect_warning(free_field_warnings(section(100.), free_field()), {});
      expect_warning(free_field_warnings(section(110.), free_field()), {}); // 2.5 m within 25 m
      expect_warning(free_field_warnings(section(160.), SceneParameters()), {}); // viscous
    }


    TEST(FreeFieldCheck, DashpotsAloneAreNamedWhereAMotionComesIn)
    {
      SceneParameters scene;
      scene.motion.type = "ricker";
      expect_warning(free_field_warnings(section(100.), scene),
                     {"Continuum/Sides = viscous",
                      "1000 m wide and 100 m high",
                      "1000 m from the middle"});
      scene.continuum.base = fixed_base();
      expect_warning(free_field_warnings(section(100.), scene), {});
    }


    TEST(FreeFieldCheck, HeldSidesAreNamedWhereTheyHoldTheMotion)
    {
      SceneParameters scene;
      scene.motion.type     = "ricker";
      scene.continuum.sides = roller_side();
      expect_warning(free_field_warnings(section(100.), scene),
                     {"Continuum/Sides = roller holds the sides", "set it to free field"});
      scene.motion.angle = 90.;
      expect_warning(free_field_warnings(section(100.), scene), {});
      scene.continuum.sides = fixed_side();
      expect_warning(free_field_warnings(section(100.), scene), {"Continuum/Sides = fixed"});
      scene.motion.type = "none";
      expect_warning(free_field_warnings(section(100.), scene), {});
    }


    /// With a plane from the side, 30 m up, by so much up or down to x = 100 m.
    SectionMesh with_plane(const double rise)
    {
      SectionMesh mesh = section(100.);
      mesh.nodes.emplace_back(0., 30.);
      mesh.nodes.emplace_back(100., 30. + rise);
      mesh.lines["left"]      = {{0, 8}, {8, 4}};
      mesh.lines["bedding_1"] = {{8, 9}};
      return mesh;
    }


    TEST(FreeFieldCheck, PlanesThatReachASideWithoutAJointAreNamed)
    {
      SectionMesh mesh = with_plane(0.);
      for (Vec2 &node : mesh.nodes)
        if (node.x() == 1000.)
          node.x() = 3000.; // as dashpots take motion out of narrow ground
      SceneParameters scene = free_field();
      scene.motion.type     = "ricker";
      scene.bedding.slips   = true;
      expect_warning(free_field_warnings(mesh, scene), {}); // welded
      scene.bedding.names = {"bedding_1"};
      expect_warning(free_field_warnings(mesh, scene), {}); // the column has its joint
      scene.bedrock = triangles_bedrock();
      expect_warning(free_field_warnings(mesh, scene), {}); // likewise
      scene.continuum.sides = viscous_side();
      expect_warning(free_field_warnings(mesh, scene),
                     {"bedding_1: where a plane reaches a side", "too little slip"});
      scene.bedding.slips = false;
      expect_warning(free_field_warnings(mesh, scene), {"bedding_1", "a little wrong"});
      scene.motion.type = "none";
      expect_warning(free_field_warnings(mesh, scene), {});
    }


    TEST(FreeFieldCheck, APlaneThatEndsInTheCornerOfASideIsHeldByNothing)
    {
      SectionMesh mesh        = with_plane(0.);
      mesh.lines["bedding_1"] = {{4, 9}}; // from the ground
      SceneParameters scene   = free_field();
      scene.motion.type       = "ricker";
      scene.bedding.names     = {"bedding_1"};
      scene.bedrock           = triangles_bedrock();
      expect_warning(free_field_warnings(mesh, scene), {});
    }


    TEST(FreeFieldCheck, PlanesThatMeetAtASideAreNamed)
    {
      SectionMesh mesh        = with_plane(0.);
      mesh.lines["bedding_2"] = {{8, 1}};
      mesh.lines["bedding_3"] = {{8, 4}}; // along the side
      SceneParameters scene   = free_field();
      scene.motion.type       = "ricker";
      scene.bedding.names     = {"bedding_1", "bedding_3"};
      expect_warning(free_field_warnings(mesh, scene), {});
      scene.bedding.names = {"bedding_1", "bedding_2"};
      expect_warning(free_field_warnings(mesh, scene),
                     {"bedding_1, bedding_2: where planes meet each other", "a little wrong"});
    }


    TEST(FreeFieldCheck, PlanesThatMeetAColumnAtAnAngleAreNamed)
    {
      SceneParameters scene = free_field();
      scene.motion.type     = "ricker";
      scene.bedding.names   = {"bedding_1"};
      expect_warning(free_field_warnings(with_plane(3.), scene), {});
      for (const double rise : {-20., 20.})
        expect_warning(free_field_warnings(with_plane(rise), scene),
                       {"bedding_1 meets a side at 11 degrees", "as in level ground"});
    }


    TEST(FreeFieldCheck, ASlopeThatBeginsAtTheSideIsNamed)
    {
      expect_warning(free_field_warnings(section(140.), free_field()),
                     {"line left", "is up to 10 m higher (at x = 25 m)", "keep it level for 25 m"});
      expect_warning(free_field_warnings(section(60.), free_field()),
                     {"line left", "is up to 10 m lower (at x = 25 m)"});
    }


    TEST(FreeFieldCheck, BlocksOnTheColumnAreNamed)
    {
      SectionMesh mesh = section(100.);
      mesh.nodes.emplace_back(1000., 103.);
      mesh.blocks = {{6, 7, 8}};
      expect_warning(free_field_warnings(mesh, free_field()),
                     {"line right",
                      "is up to 3 m higher (at x = 1000 m)",
                      "which is 100 m high and ends at y = 100 m"});
      SceneParameters scene = free_field();
      scene.blocks.enabled  = false;
      expect_warning(free_field_warnings(mesh, scene), {});
    }
  } // namespace
} // namespace hybrid::scene
