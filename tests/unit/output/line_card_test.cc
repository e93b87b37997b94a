// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/line_card.h>
#include <hybrid/scene/bedrock/layers_bedrock.h>
#include <hybrid/scene/bedrock/rigid_bedrock.h>
#include <hybrid/scene/boundary/fixed_base.h>
#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/rigid_base.h>

#include <gtest/gtest.h>

namespace hybrid::output
{
  namespace
  {
    /// A line of 2 m for each name.
    scene::SectionMesh mesh_with(const std::vector<std::string> &names)
    {
      scene::SectionMesh mesh;
      mesh.nodes = {{0., 0.}, {2., 0.}};
      for (const std::string &name : names)
        mesh.lines[name] = {{0, 1}};
      return mesh;
    }


    void expect_row(const std::string &text, const std::string &names, const std::string &role)
    {
      const auto begin = text.find("\n  " + names + " ");
      ASSERT_NE(begin, std::string::npos) << names << " is not in" << text;
      EXPECT_NE(text.substr(begin + 1, text.find('\n', begin + 1) - begin).find(role),
                std::string::npos)
        << text;
    }


    TEST(LineCard, PlanesThatNoParameterNamesAreWelded)
    {
      const auto             mesh = mesh_with({"bedding_1", "bedding_2", "bedding_3"});
      scene::SceneParameters scene;
      scene.bedding.names = {"bedding_2"};
      std::string text    = describe_lines(mesh, scene);
      expect_row(text, "bedding_1, bedding_3", "4 m  welded, as Bedding planes/Names does not");
      expect_row(text, "bedding_2", "2 m  elastic joint");
      scene.bedding.slips = true;
      expect_row(describe_lines(mesh, scene), "bedding_2", "joint that slips and opens");
    }


    TEST(LineCard, TheSlidingSurfaceIsABeltOrAContact)
    {
      const auto             mesh = mesh_with({"sliding_surface"});
      scene::SceneParameters scene;
      expect_row(describe_lines(mesh, scene), "sliding_surface", "unbonded contact with friction");
      for (const char *name : {"rock", "belt", "wet"})
        scene.materials[name].friction_angle = 30.;
      scene.blocks.material                = "rock";
      scene.blocks.belt_material           = "belt";
      scene.blocks.saturated_belt_material = "wet";
      expect_row(describe_lines(mesh, scene),
                 "sliding_surface",
                 "bonded to blocks that share its edges, belt material belt");
      scene.environment.water_level = 175.;
      expect_row(describe_lines(mesh, scene),
                 "sliding_surface",
                 "belt material belt (below the water wet)");
      scene.blocks.enabled = false;
      expect_row(describe_lines(mesh, scene), "sliding_surface", "free surface, as there are no");
    }


    TEST(LineCard, JointsOfTheMassHaveTheirStrength)
    {
      auto                   mesh = mesh_with({"joint_a", "joint_b"});
      scene::SceneParameters scene;
      scene.blocks.material                  = "rock";
      scene.blocks.joint_materials           = scene::RegionMaterials::parse("joint_a: clay");
      scene.blocks.saturated_joint_materials = "wet";
      scene.materials["clay"].name           = "clay";
      scene.materials["clay"].friction_angle = 12.;
      scene.materials["clay"].cohesion       = 5e3;
      scene.materials["wet"]                 = scene.materials["clay"];
      scene.materials["wet"].name            = "wet";
      std::string text                       = describe_lines(mesh, scene);
      expect_row(text, "joint_a", "joints of clay (phi 12 deg, c 5000 Pa, tensile strength 0 Pa)");
      expect_row(text, "joint_b", "like all other edges of blocks, as Blocks/Joint materials does");
      EXPECT_EQ(text.find("wet"), std::string::npos);
      scene.environment.water_level = 175.;
      scene.blocks.bonded           = false;
      text                          = describe_lines(mesh, scene);
      expect_row(text, "joint_a", "contacts of clay (phi 12 deg");
      expect_row(text, "joint_a", "below the water of wet (phi 12 deg");
      scene.blocks.enabled = false;
      expect_row(describe_lines(mesh, scene),
                 "joint_a, joint_b",
                 "not used, as there are no blocks");
    }


    TEST(LineCard, FrictionBeyondTheBeltIsToldWhereItIsAnotherOne)
    {
      const auto             mesh = mesh_with({"sliding_surface"});
      scene::SceneParameters scene;
      for (const char *name : {"rock", "belt", "clay"})
        scene.materials[name].friction_angle = 30.;
      scene.blocks.material      = "rock";
      scene.blocks.belt_material = "belt";
      const std::string beyond   = "blocks that have slid beyond the bonded part have the friction";
      EXPECT_EQ(describe_lines(mesh, scene).find(beyond), std::string::npos);

      scene.materials["belt"].residual_friction_angle = 12.;
      expect_row(describe_lines(mesh, scene), "sliding_surface", beyond);
      expect_row(describe_lines(mesh, scene),
                 "sliding_surface",
                 "of Blocks/Material (rock: 30 deg)");

      scene.materials["belt"].residual_friction_angle = -1.;
      scene.materials["belt"].cohesion                = 1e4; // stays with the belt alone
      expect_row(describe_lines(mesh, scene), "sliding_surface", beyond);

      scene.continuum.region_material["bedrock"] = "clay";
      scene.materials["clay"].friction_angle     = 20.;
      EXPECT_EQ(describe_lines(mesh, scene).find("clay"), std::string::npos); // nobody has given it
      scene.materials["clay"].given_friction_angle = 20.;
      expect_row(describe_lines(mesh, scene),
                 "sliding_surface",
                 "or of the ground where that is less (clay: 20 deg)");

      scene.environment.water_level   = 10.;
      scene.blocks.saturated_material = "clay";
      expect_row(describe_lines(mesh, scene),
                 "sliding_surface",
                 "(rock: 30 deg), below the water of (clay: 20 deg)");
    }


    TEST(LineCard, TellsWhatNodesOfTheirOwnLeaveUnbonded)
    {
      // Two squares side by side on two edges of the sliding surface; the second one has nodes of
      // its own where the two meet, and below.
      scene::SectionMesh mesh;
      mesh.nodes = {{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1., 1.}, {2., 1.}, {1., 0.}, {1., 1.}};
      mesh.blocks                   = {{0, 1, 4, 3}, {6, 2, 5, 7}};
      mesh.lines["sliding_surface"] = {{0, 1}, {1, 2}};
      scene::SceneParameters scene;
      scene.materials["rock"];
      scene.materials["belt"];
      scene.blocks.material      = "rock";
      scene.blocks.belt_material = "belt";
      std::string text           = describe_lines(mesh, scene);
      expect_row(text, "sliding_surface", "share its edges, belt material belt (1 of its 2 edges)");
      expect_row(text, "between blocks", "1 m  cut: 1 edge has two nodes in one place");
      mesh.blocks = {{0, 1, 4, 3}, {1, 2, 5, 4}};
      text        = describe_lines(mesh, scene);
      EXPECT_EQ(text.find("of its"), std::string::npos);
      EXPECT_EQ(text.find("between blocks"), std::string::npos);
    }


    TEST(LineCard, TheLowestLayerMovesUnlessTheBaseIsFixed)
    {
      const auto             mesh = mesh_with({"base"});
      scene::SceneParameters scene;
      scene.bedrock = scene::layers_bedrock();
      for (const auto &base : {scene::compliant_base(), scene::rigid_base()})
        {
          scene.continuum.base = base;
          expect_row(describe_lines(mesh, scene), "base", "lowest layer, which moves");
        }
      scene.continuum.base = scene::fixed_base();
      expect_row(describe_lines(mesh, scene), "base", "fixed base");
    }


    TEST(LineCard, BoundariesSayWhatTheyAre)
    {
      const auto             mesh = mesh_with({"base", "left", "right", "ground", "mass_surface"});
      scene::SceneParameters scene;
      scene.continuum.sides = scene::free_field_side();
      std::string text      = describe_lines(mesh, scene);
      expect_row(text, "base", "compliant base");
      expect_row(text, "left, right", "4 m  side: free field");
      expect_row(text, "ground", "free surface of the bedrock");
      expect_row(text, "mass_surface", "only drawn");
      scene.bedrock = scene::rigid_bedrock();
      text          = describe_lines(mesh, scene);
      expect_row(text, "ground", "surface of the rigid base");
      expect_row(text, "base, left, right", "not used, as the bedrock is rigid");
      EXPECT_EQ(describe_lines(mesh_with({}), scene), "");
    }
  } // namespace
} // namespace hybrid::output
