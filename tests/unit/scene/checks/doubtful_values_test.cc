// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/doubtful_values.h>

#include <gtest/gtest.h>

namespace hybrid::scene
{
  namespace
  {
    /// Clay on Earth, in the units that are asked for.
    SceneParameters sound_scene()
    {
      SceneParameters scene;
      Material        clay;
      clay.density              = 2000.;
      clay.young_modulus        = 20e6;
      clay.friction_angle       = 25.;
      clay.cohesion             = 20e3;
      clay.tensile_strength     = 0.;
      scene.materials["clay"]   = clay;
      scene.environment.gravity = 9.81;
      return scene;
    }


    /// The only warning of a scene in which @p value has been given to a member of the clay.
    std::string warning_of(double Material::*member, const double value)
    {
      SceneParameters scene              = sound_scene();
      scene.materials.at("clay").*member = value;
      const auto warnings                = doubtful_values(scene);
      return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
    }


    std::string warning_of_gravity(const double value)
    {
      SceneParameters scene     = sound_scene();
      scene.environment.gravity = value;
      const auto warnings       = doubtful_values(scene);
      return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
    }


    TEST(DoubtfulValues, SoundScenesAreNotDoubted)
    {
      EXPECT_TRUE(doubtful_values(sound_scene()).empty());
      EXPECT_EQ(warning_of(&Material::cohesion, 0.), "0 warnings");
      EXPECT_EQ(warning_of(&Material::friction_angle, 0.), "0 warnings");
      EXPECT_EQ(warning_of(&Material::young_modulus, 7e10), "0 warnings");
      EXPECT_EQ(warning_of_gravity(0.), "0 warnings");
    }


    TEST(DoubtfulValues, TheLikelyUnitIsNamed)
    {
      EXPECT_EQ(
        warning_of(&Material::density, 2.2),
        "Materials/clay/Density = 2.2 kg/m3 is doubtful: expected is 300 to 12000 kg/m3; if it "
        "was meant in t/m3, give 2200");
      EXPECT_NE(warning_of(&Material::density, 19.62).find("in kN/m3, give 2000"),
                std::string::npos);
      EXPECT_NE(warning_of(&Material::density, 19620.).find("in N/m3, give 2000"),
                std::string::npos);
      EXPECT_NE(warning_of(&Material::young_modulus, 5.).find("in GPa, give 5e+09"),
                std::string::npos);
      EXPECT_NE(warning_of(&Material::young_modulus, 5000.).find("in MPa, give 5e+09"),
                std::string::npos);
      EXPECT_NE(warning_of(&Material::friction_angle, 0.5).find("in radians, give 28.65"),
                std::string::npos);
      EXPECT_NE(warning_of(&Material::cohesion, 20.)
                  .find("at least 50 Pa; if it was meant in kPa, give 20000"),
                std::string::npos);
      EXPECT_NE(warning_of(&Material::tensile_strength, 0.1).find("in kPa, give 100"),
                std::string::npos);
      EXPECT_NE(warning_of_gravity(1.).find(
                  "Gravity/Acceleration = 1 m/s2 is doubtful: expected is "
                  "1.5 to 2000 m/s2; if it was meant in g, give 9.81"),
                std::string::npos);
    }


    TEST(DoubtfulValues, DampingBeyondTheCriticalOneIsDoubted)
    {
      SceneParameters scene              = sound_scene();
      scene.continuum.rayleigh_mass      = 2.;
      scene.continuum.rayleigh_stiffness = 0.01;
      EXPECT_TRUE(doubtful_values(scene).empty());
      scene.continuum.rayleigh_mass      = 1105.;
      scene.continuum.rayleigh_stiffness = 5.;
      scene.environment.water_density    = 1.;
      const auto warnings                = doubtful_values(scene);
      ASSERT_EQ(warnings.size(), 3u);
      EXPECT_EQ(
        warnings[0],
        "Water/Density = 1 kg/m3 is doubtful: expected is 500 to 2500 kg/m3; if it was meant "
        "in t/m3, give 1000");
      EXPECT_EQ(warnings[1],
                "Continuum/Rayleigh mass = 1105 1/s is doubtful: expected is 0 to 12.57 1/s");
    }


    TEST(DoubtfulValues, PlanesAndBlocksHaveTheirUnits)
    {
      SceneParameters scene          = sound_scene();
      scene.bedding.normal_stiffness = 8.;
      EXPECT_TRUE(doubtful_values(scene).empty()); // no planes
      scene.bedding.names = {"bedding_1"};
      auto warnings       = doubtful_values(scene);
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_EQ(warnings[0],
                "Bedding planes/Normal stiffness = 8 Pa/m is doubtful: expected is 100000 to 1e+14 "
                "Pa/m; if it was meant in GPa/m, give 8e+09");
      scene.bedding.normal_stiffness = 8e9;
      scene.bedding.slips            = true;
      scene.bedding.friction_angle   = 0.35;
      scene.blocks.softening_slip    = 100.;
      scene.blocks.tolerance         = 0.9;
      warnings                       = doubtful_values(scene);
      ASSERT_EQ(warnings.size(), 3u);
      EXPECT_NE(warnings[0].find("in radians, give 20.05"), std::string::npos);
      EXPECT_NE(warnings[1].find("in mm, give 0.1"), std::string::npos);
      EXPECT_EQ(warnings[2], "Blocks/Tolerance = 0.9 is doubtful: expected is 1e-12 to 0.0001");
    }


    TEST(DoubtfulValues, AMotionStrongerThanAnyRecordIsDoubted)
    {
      SceneParameters scene = sound_scene();
      const Motion    motion(0.01, {0., 240., -10., 0.});
      EXPECT_TRUE(doubtful_values(scene, motion.scaled(0.1)).empty());
      scene.motion.peak = 240.;
      auto warnings     = doubtful_values(scene, motion);
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_EQ(warnings[0],
                "Motion/Peak = 240 m/s2 is doubtful: expected is 0 to 50 m/s2; if it was meant in "
                "cm/s2, give 2.4");
      scene.motion.peak = -1.; // as recorded
      scene.motion.file = "quake.txt";
      warnings          = doubtful_values(scene, motion);
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_EQ(warnings[0],
                "quake.txt: the peak of 240 m/s2 is doubtful: expected is 0 to 50 m/s2; if it was "
                "meant in cm/s2, set Motion/Unit = cm/s2");
      scene.environment.gravity = 50. * 9.81; // in a centrifuge
      EXPECT_TRUE(doubtful_values(scene, motion).empty());
    }


    TEST(DoubtfulValues, ABuoyantDensityOfTheSaturatedBodyIsDoubted)
    {
      SceneParameters scene           = sound_scene();
      scene.materials["wet"]          = scene.materials.at("clay");
      scene.materials["wet"].density  = 1250.;
      scene.materials["wet"].name     = "wet";
      scene.materials["clay"].name    = "clay";
      scene.blocks.material           = "clay";
      scene.blocks.saturated_material = "wet";
      EXPECT_TRUE(doubtful_values(scene).empty()); // no water
      scene.environment.water_level = 10.;
      const auto warnings           = doubtful_values(scene);
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_EQ(
        warnings[0],
        "Materials/wet/Density = 1250 kg/m3 of the saturated body is below that of clay, 2000 "
        "kg/m3: as a buoyant density it makes inertia too small and S waves 34.16 % too fast; "
        "give the total density, 2250, and set Water/Method = submerged or pressures");
      scene.materials["wet"].density = 600.;
      EXPECT_TRUE(doubtful_values(scene).empty()); // not even with water
      scene.materials["wet"].density = 2100.;
      EXPECT_TRUE(doubtful_values(scene).empty());
    }


    TEST(DoubtfulValues, APeakThatMayBeInGNeedsItsUnit)
    {
      SceneParameters scene = sound_scene();
      const Motion    motion(0.01, {0., 0.3, -0.1, 0.});
      scene.motion.type = "sine";
      EXPECT_TRUE(doubtful_values(scene, motion).empty()); // nobody gave a peak
      scene.motion.peak = 0.3;
      auto warnings     = doubtful_values(scene, motion);
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_EQ(
        warnings[0],
        "Motion/Peak = 0.3 is read as 0.3 m/s2 (0.03059 g), a weak shaking: if it was meant "
        "in g, set Peak = 0.3 g, else Peak = 0.3 m/s2");
      scene.motion.peak_has_unit = true;
      EXPECT_TRUE(doubtful_values(scene, motion).empty());
      scene.motion.peak_has_unit = false;
      scene.motion.peak          = 3.;
      EXPECT_TRUE(doubtful_values(scene, motion.scaled(10.)).empty());
      scene.motion.vertical_peak = 0.2;
      EXPECT_NE(doubtful_values(scene, motion.scaled(10.)).at(0).find("Motion/Vertical peak = 0.2"),
                std::string::npos);
      scene.motion.vertical_peak_has_unit = true;
      EXPECT_TRUE(doubtful_values(scene, motion.scaled(10.)).empty());
    }


    TEST(DoubtfulValues, ARecordThatMayBeInGNeedsItsUnit)
    {
      SceneParameters scene = sound_scene();
      const Motion    motion(0.01, {0., 0.3, -0.1, 0.});
      scene.motion.type = "text";
      scene.motion.file = "quake.txt";
      auto warnings     = doubtful_values(scene, motion);
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_EQ(
        warnings[0],
        "quake.txt: its peak is read as 0.3 m/s2 (0.03059 g), a weak shaking, as Motion/Unit "
        "is not set: if the file is in g, set Unit = g, else Unit = m/s2");
      scene.motion.type          = "spectrum";
      scene.motion.spectrum_file = "target.txt";
      EXPECT_NE(doubtful_values(scene, motion).at(0).find("target.txt: its peak"),
                std::string::npos);
      scene.motion.file_unit_is_set = true;
      EXPECT_TRUE(doubtful_values(scene, motion).empty());
      scene.motion.type = "at2"; // in g by itself
      EXPECT_TRUE(doubtful_values(scene, motion).empty());
    }


    TEST(DoubtfulValues, ARecordInMillisecondsOrWithoutMotionIsDoubted)
    {
      SceneParameters scene = sound_scene();
      scene.motion.type     = "text";
      scene.motion.file     = "quake.txt";
      EXPECT_TRUE(doubtful_values(scene, Motion(0.01, {0., 1., 0.})).empty());
      auto warnings = doubtful_values(scene, Motion(10., {0., 1., 0.}));
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_NE(warnings[0].find("quake.txt: the samples are 10 s apart"), std::string::npos);
      warnings = doubtful_values(scene, Motion(0.01, {0., 0., 0.}));
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_NE(warnings[0].find("all accelerations are zero"), std::string::npos);
    }


    TEST(DoubtfulValues, WhereNoUnitHelpsNoneIsNamed)
    {
      EXPECT_EQ(warning_of(&Material::young_modulus, 1e15).find("meant"), std::string::npos);
      EXPECT_EQ(warning_of(&Material::density, 1e9).find("meant"), std::string::npos);
    }
  } // namespace
} // namespace hybrid::scene
