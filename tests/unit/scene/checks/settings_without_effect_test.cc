// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/bedrock/layers_bedrock.h>
#include <hybrid/scene/bedrock/rigid_bedrock.h>
#include <hybrid/scene/bedrock/triangles_bedrock.h>
#include <hybrid/scene/boundary/fixed_base.h>
#include <hybrid/scene/checks/settings_without_effect.h>

#include <gtest/gtest.h>

#include "expect_warning.h"

namespace hybrid::scene
{
  namespace
  {
    class SettingsWithoutEffect : public testing::Test
    {
    protected:
      SceneParameters scene;

      void SetUp() override
      {
        scene.bedrock = continuum_bedrock();
      }

      void expect(const std::vector<std::string> &words) const
      {
        hybrid::test::expect_warning(settings_without_effect(scene), words);
      }
    };
  } // namespace


  TEST_F(SettingsWithoutEffect, AFixedBaseLetsNoMotionIn)
  {
    scene.motion.type = "ricker";
    expect({});
    scene.continuum.base = fixed_base();
    expect({"Motion/Type = ricker has no effect", "Continuum/Base = fixed"});
    scene.bedrock = rigid_bedrock();
    for (const BedrockModel &blocks : {layers_bedrock(), triangles_bedrock()})
      {
        scene.bedrock = blocks;
        expect({"Motion/Type = ricker has no effect", "Continuum/Base = fixed"});
      }
    scene.bedrock = rigid_bedrock(); // it moves by itself
    expect({});
  }


  TEST_F(SettingsWithoutEffect, ALevelInTimeLeavesThePorePressureOfPlanes)
  {
    scene.bedding.names = {"bedding_1"};
    scene.bedding.slips = true;
    expect({});
    scene.environment.water_level             = 8.;
    scene.environment.water_method            = WaterMethod::pressures;
    scene.environment.water_tables.level_file = "level.csv";
    expect({"Water/Level file does not change the pore pressure in bedding planes"});
    scene.environment.static_stage = StaticStage::none;
    expect({"bedding planes are dry, though there is water"});
    scene.bedding.slips = false;
    expect({});
  }


  TEST_F(SettingsWithoutEffect, NumbersThatTheCommandLineLeavesOut)
  {
    scene.mesh.left_out = {"Width = 60", "Height = 5"};
    expect({"Width = 60; Height = 5 of the scene has no effect"});
  }


  TEST_F(SettingsWithoutEffect, TheSurfaceOfAContinuumBelowBlocksHasAStiffness)
  {
    scene.continuum.surface_form = SurfaceForm::banded;
    expect({});
    scene.blocks.enabled = false;
    expect({"Continuum/Surface stiffness has no effect", "no blocks"});
    scene.bedrock = rigid_bedrock();
    expect({"Continuum/Surface stiffness has no effect", "no continuum"});
    scene.continuum.surface_form = SurfaceForm::automatic;
    expect({});
  }


  TEST_F(SettingsWithoutEffect, ARecordIsReadByItsTypesOnly)
  {
    scene.motion.file = "quake.txt";
    for (const char *type : {"none", "text", "at2"})
      {
        scene.motion.type = type;
        expect({});
      }
    scene.motion.type = "ricker";
    expect({"Motion/File = quake.txt is not read", "Motion/Type = ricker"});
  }


  TEST_F(SettingsWithoutEffect, AMagnitudeIsThatOfAStochasticMotion)
  {
    scene.motion.earthquake.magnitude = 6.;
    for (const char *type : {"none", "stochastic"})
      {
        scene.motion.type = type;
        expect({});
      }
    scene.motion.type = "ricker";
    expect({"Motion/Magnitude and Distance have no effect", "Motion/Type = ricker", "stochastic"});
  }


  TEST_F(SettingsWithoutEffect, StressAtRestIsOfWhatBodiesAreMadeOf)
  {
    scene.blocks.material            = RegionMaterials("rock");
    scene.environment.initial_stress = "rock: 3; flat: 0.3";
    expect({"Gravity/Initial stress of 'flat' has no effect"});
    scene.environment.initial_stress = "rock: 3";
    expect({});
  }


  TEST_F(SettingsWithoutEffect, LooseBlocksHaveNoBonds)
  {
    scene.materials["rock"].name     = "rock";
    scene.materials["rock"].cohesion = 1e6;
    scene.materials["flat"]          = scene.materials["rock"];
    Material &flat                   = scene.materials["flat"];
    flat.friction_angle              = 45.;
    flat.residual_friction_angle     = 20.;
    scene.blocks.material            = RegionMaterials("rock");
    scene.blocks.joint_materials     = RegionMaterials::parse("joint_flat: flat");
    scene.blocks.bonded              = true;
    expect({});
    scene.blocks.bonded                     = false;
    const std::vector<std::string> warnings = settings_without_effect(scene);
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_EQ(warnings[0],
              "Cohesion and Tensile strength of 'rock', 'flat' do not act between blocks, as "
              "Model/Blocks = loose has no bonds");
    EXPECT_EQ(warnings[1],
              "contacts slide at the Residual friction angle from the start, as Model/Blocks = "
              "loose has no bonds: 20 degrees of 'flat'");
    scene.blocks.enabled = false;
    expect({});
  }


  TEST_F(SettingsWithoutEffect, ARigidBedrockHasNoPlanes)
  {
    scene.bedding.names = {"bedding_1", "bedding_2"};
    expect({});
    scene.bedrock = rigid_bedrock();
    expect({"Bedding planes/Names = bedding_1, ... has no effect", "rigid"});
  }
} // namespace hybrid::scene
