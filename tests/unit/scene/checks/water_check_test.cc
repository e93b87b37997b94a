// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/bedrock/rigid_bedrock.h>
#include <hybrid/scene/checks/water_check.h>

#include <gtest/gtest.h>

#include "expect_warning.h"

namespace hybrid::scene
{
  namespace
  {
    class WaterCheck : public testing::Test
    {
    protected:
      SectionMesh            mesh;
      SceneParameters        scene;
      EnvironmentParameters &around = scene.environment;

      /// Two squares of 10 m on a slope, at (0, 0) and (10, 5), with friction and 2200 kg/m3.
      void SetUp() override
      {
        mesh.nodes = {
          {0., 0.}, {10., 0.}, {10., 10.}, {0., 10.}, {10., 5.}, {20., 5.}, {20., 15.}, {10., 15.}};
        mesh.blocks             = {{0, 1, 2, 3}, {4, 5, 6, 7}};
        mesh.block_region       = {0, 0};
        mesh.block_region_names = {"sliding_mass"};
        scene.bedrock           = rigid_bedrock();
        add_material("dry", 2200.);
        scene.blocks.material = "dry";
        around.water_method   = WaterMethod::submerged;
      }

      void add_material(const std::string &name, const double density)
      {
        scene.materials[name].name    = name;
        scene.materials[name].density = density;
      }

      /// Saturated material of this density, level through the blocks, Water/Method = paper.
      void saturate(const double density)
      {
        add_material("wet", density);
        scene.blocks.saturated_material = "wet";
        around.water_level              = 8.;
        around.water_method             = WaterMethod::paper;
      }

      void draw_line(const std::vector<Vec2> &points)
      {
        around.water_tables.line.points = points;
      }

      void expect(const std::vector<std::string> &words) const
      {
        hybrid::test::expect_warning(water_warnings(mesh, scene), words);
      }
    };
  } // namespace


  TEST_F(WaterCheck, WaterMustReachABlockAndDoSomething)
  {
    expect({}); // none
    around.water_method = WaterMethod::paper;
    around.water_level  = 5.5;
    expect({"Water/Level = 5.5 m has no effect", "Blocks/Saturated material"});
    saturate(1300.);
    expect({});
    around.water_method = WaterMethod::pressures;
    expect({});
    around.water_level = -100.;
    expect({"Water/Level = -100 m has no effect", "100 m above it at (0, 0) m"});
    scene.blocks.enabled = false;
    scene.bedrock        = continuum_bedrock();
    expect({"acts on blocks and there are none"});
  }


  TEST_F(WaterCheck, ALineBelowAllBlocksHasNoEffect)
  {
    draw_line({{-50., -40.}, {10., -2.}, {50., 4.}}); // above the lowest block beside it
    expect({"the water (section Water), up to -0.5 m, has no effect", "2 m above it at (10, 0) m"});
    draw_line({{-50., -40.}, {4., -40.}, {5., 0.1}, {6., -40.}, {50., -40.}}); // between nodes
    expect({});
    draw_line({{-50., -40.}, {4., -40.}, {5., -0.1}, {6., -40.}, {50., -40.}});
    expect({"0.1 m above it at (5, 0) m"});
    scene.bedding.names = {"bedding_1"};
    scene.bedding.slips = true; // they bear the pore pressure
    expect({});
  }


  TEST_F(WaterCheck, OnlyTheLineOverTheSectionCounts)
  {
    draw_line({{0., 5.}, {20., 10.}, {5000., 1000.}});
    expect({});
    draw_line({{1000., 5.}, {2000., 60.}});
    expect({"x = 1000 to 2000 m, lie beside the section, x = 0 to 20 m", "stays at 5 m", "origin"});
    draw_line({{-200., 60.}, {-100., 5.}});
    expect({"x = -200 to -100 m, lie beside the section"});
    draw_line({{-200., 5.}, {-100., 5.}});
    expect({}); // level everywhere
    draw_line({{7., 5.}});
    expect({});
  }


  TEST_F(WaterCheck, WaterOfAnotherDatumIsNamed)
  {
    around.water_level = 100.; // less than 100 m above
    expect({});
    around.water_level = 175.;
    expect({"Water/Level = 175 m is 160 m above", "(20, 15) m: everything is under water"});
    around.water_level = -1e300;
    draw_line({{0., 5.}, {10., 8.}, {20., 175.}});
    expect({"the water, up to 175 m, is 160 m above", "a part of it is under water"});
  }


  TEST_F(WaterCheck, AWeightWithoutBuoyancyIsDoubtedWhereNoPressureActs)
  {
    saturate(2250.);
    expect({"'wet' weighs 2250 kg/m3", "'dry', which has 2200 kg/m3", "at most 1800", "submerged"});
    around.water_method_is_set = true;
    expect({"'wet' weighs 2250 kg/m3"});
    around.gravity = 0.;
    expect({});
    around.gravity = 9.81;
    saturate(2200.);
    expect({}); // the same weight, and paper is what was wanted
    around.water_method_is_set = false;
    expect({"'wet' weighs 2200 kg/m3"});
    scene.materials["wet"].weight_density = 1350.;
    expect({});
    scene.materials["wet"].weight_density = 1801.;
    expect({"'wet' weighs 1801 kg/m3"});
    around.water_level = 4.; // below the middle of both
    expect({});
  }


  TEST_F(WaterCheck, StrengthWithoutFrictionTakesNoNoticeOfPressure)
  {
    saturate(2250.);
    scene.materials["wet"].friction_angle = 0.;
    expect({});
    add_material("belt", 2200.);
    scene.blocks.belt_material = "belt";
    expect({"'wet' weighs 2250 kg/m3"});
    scene.materials["belt"].friction_angle = 0.;
    expect({});
  }


  TEST_F(WaterCheck, EventsWithDifferentLevelsAreNoEventsOfOneMotion)
  {
    around.water_level               = 8.;
    around.water_tables.level.points = {{0., 8.}, {10., 6.}, {20., 6.}};
    scene.motion.type                = "sine";
    expect({});
    scene.motion.repetitions = 2;
    expect({"Motion/Repetitions = 2: Water/Level file changes the level after Motion/Start = 0 s"});
    scene.motion.start = 10.;
    expect({});
    scene.motion.start = 5.;
    scene.motion.type  = "none";
    expect({});
  }
} // namespace hybrid::scene
