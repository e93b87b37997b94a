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
        test::expect_warning(settings_without_effect(scene), words);
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


  TEST_F(SettingsWithoutEffect, ARigidBedrockHasNoPlanes)
  {
    scene.bedding.names = {"bedding_1", "bedding_2"};
    expect({});
    scene.bedrock = rigid_bedrock();
    expect({"Bedding planes/Names = bedding_1, ... has no effect", "rigid"});
  }
} // namespace hybrid::scene
