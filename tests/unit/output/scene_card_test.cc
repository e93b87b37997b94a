// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/output/scene_card.h>
#include <hybrid/scene/bedrock/layers_bedrock.h>
#include <hybrid/scene/bedrock/rigid_bedrock.h>
#include <hybrid/scene/boundary/fixed_base.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    /// A Ricker wavelet of 5 Hz in steps of @p dt [s].
    scene::Motion sampled_wavelet(const double dt)
    {
      std::vector<double> a;
      for (double t = -0.3; t <= 0.3; t += dt)
        {
          const double s = std::pow(M_PI * 5. * t, 2);
          a.push_back((1. - 2. * s) * std::exp(-s));
        }
      return {dt, a};
    }


    TEST(SceneCard, TheHighestFrequencyDoesNotDependOnTheSpacing)
    {
      // 95 % of a Ricker wavelet's energy are below 1.664 of its frequency.
      for (const double dt : {1e-2, 1e-3, 1e-6})
        EXPECT_NEAR(highest_frequency(sampled_wavelet(dt)), 8.32, 0.13) << dt;
      EXPECT_EQ(highest_frequency(scene::Motion()), 0.);
    }


    TEST(SceneCard, SaysWhatTheBaseOfLayersDoes)
    {
      scene::SceneParameters scene;
      scene.bedrock   = scene::layers_bedrock();
      const auto card = [&scene] { return make_scene_card(scene, {}, nullptr, nullptr).text; };
      EXPECT_NE(card().find("layers, base rigid"), std::string::npos) << card();
      scene.continuum.base = scene::fixed_base();
      EXPECT_NE(card().find("layers, base fixed"), std::string::npos) << card();
    }


    TEST(SceneCard, SaysHowManyBlocksAnInitialVelocityMoves)
    {
      scene::SceneParameters scene    = test::block_parameters(30.);
      scene.bedrock                   = scene::rigid_bedrock();
      scene.blocks.initial_velocities = {{"upper", {0., 1.}, {9., 9.}, {2., -1.}, 0.5},
                                         {"one", {0., 0.}, {1., 1.}, {0., 0.}, 1.}};
      const dda::Model model =
        dda::build_model(test::square_blocks(2, 2), scene, test::straight_foundation(0., 1., 6.));
      const std::string card = make_scene_card(scene, {}, &model, nullptr).text;
      EXPECT_NE(card.find("Velocity   upper: 2 of 4 blocks with 2, -1 m/s, 0.5 rad/s\n"),
                std::string::npos)
        << card;
      EXPECT_NE(card.find("Velocity   one: 1 of 4 blocks with 0, 0 m/s, 1 rad/s\n"),
                std::string::npos)
        << card;
    }


    /// The same mass has the same counts on every bedrock.
    TEST(SceneCard, CountsTheBeltByEdgesHoweverManyNodesTheBedrockHas)
    {
      scene::SceneParameters scene  = test::block_parameters(30.);
      scene.bedrock                 = scene::rigid_bedrock();
      scene.blocks.bonded           = true;
      scene.blocks.belt_material    = "rock";
      scene::SectionMesh mesh       = test::square_blocks(2, 2);
      mesh.lines["sliding_surface"] = {{0, 1}, {1, 2}};
      const auto card               = [&](const int pieces) {
        const dda::Model model =
          dda::build_model(mesh, scene, test::straight_foundation(0., 1., 3., pieces));
        return make_scene_card(scene, {}, &model, nullptr).text;
      };
      const std::string counts = "Blocks     4 blocks, 4 joints between them, a belt of 2 edges";
      EXPECT_NE(card(4).find(counts + ", size"), std::string::npos) << card(4);
      EXPECT_NE(card(8).find(counts + " in 4 joints (parted at the nodes of the bedrock), size"),
                std::string::npos)
        << card(8);
      scene.blocks.belt_material.clear();
      EXPECT_NE(card(4).find("Blocks     4 blocks, 4 joints between them, size"),
                std::string::npos);
    }


    TEST(SceneCard, NamesTheMaterialsOfRegions)
    {
      scene::SceneParameters scene;
      for (const char *const name : {"rock", "soil", "mud"})
        scene.materials[name].name = name;
      scene.bedrock         = scene::rigid_bedrock();
      scene.blocks.material = scene::RegionMaterials::parse("*: rock; sliding_mass_debris: soil");
      scene.blocks.saturated_material = scene::RegionMaterials::parse("sliding_mass_debris: mud");
      const auto        card   = [&] { return make_scene_card(scene, {}, nullptr, nullptr).text; };
      const std::string debris = "  material           on   sliding_mass_debris: soil";
      EXPECT_NE(card().find(debris + "\n  material           on   all other regions: rock\n"),
                std::string::npos);
      scene.environment.water_level = 3.;
      EXPECT_NE(card().find(debris + ", below the water mud\n"), std::string::npos);
    }


    TEST(SceneCard, SaysWhatABeltHasAfterSlip)
    {
      scene::SceneParameters scene;
      Material               belt;
      belt.name             = "clay";
      belt.friction_angle   = 14.72;
      belt.cohesion         = 19.76e3;
      scene.materials       = {{"clay", belt}};
      scene.bedrock         = scene::rigid_bedrock();
      scene.blocks.material = scene.blocks.belt_material = "clay";
      const auto card = [&scene] { return make_scene_card(scene, {}, nullptr, nullptr).text; };
      EXPECT_NE(card().find("clay: phi 14.72 deg, c 19760 Pa, residual = peak"), std::string::npos);
      scene.materials["clay"].residual_friction_angle = 8.;
      EXPECT_NE(card().find("residual phi 8 deg, c 19760 Pa"), std::string::npos);
      scene.materials["clay"].residual_cohesion = 0.;
      EXPECT_NE(card().find("residual phi 8 deg, c 0 Pa"), std::string::npos);
    }
  } // namespace
} // namespace hybrid::output
