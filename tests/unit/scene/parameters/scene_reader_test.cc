// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_files.h"

#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/rigid_base.h>

#include <regex>
#include <sstream>

using namespace hybrid;
using namespace hybrid::scene;

using SceneReader = test::SceneFiles;

namespace
{
  const char *const full_scene = R"(
set Title = A slope with everything
subsection Time
  set End time                   = 12.5
  set Time step                  = 5e-4
  set Maximum halvings           = 6
  set Scheme                     = shi
  set Maximum displacement ratio = 0.001
  set Dynamic coefficient        = 0.98
end
subsection Mesh
  set File    = mesh/section.geo
  set Numbers = Resolution/h = 4; Resolution/far = 20
end
subsection Model
  set Bedrock = continuum
  set Blocks    = loose
end
subsection Materials
  set Names = rock, clay, wet
  subsection rock
    set Density       = 2450
    set Young modulus = 60e9
    set Poisson ratio = 0.2
  end
  subsection clay
    set Density          = 2220
    set Friction angle   = 27.03
    set Cohesion         = 80.18e3
    set Tensile strength = 60e3
  end
  subsection wet
    set Density                 = 2320
    set Weight density          = 1320
    set Friction angle          = 16.6
    set Residual friction angle = 12
    set Cohesion                = 40e3
    set Residual cohesion       = 10e3
  end
end
subsection Continuum
  set Degree             = 3
  set Materials          = bedrock: rock; bedrock_soil: clay
  set Base               = rigid
  set Sides              = free field
  set Half space material = rock
  set Rayleigh mass      = 0.1
  set Rayleigh stiffness = 1e-4
end
subsection Bedding planes
  set Names            = bedding_1, bedding_2
  set Normal stiffness = 1e10
  set Shear stiffness  = 2e9
end
subsection Blocks
  set Material                = clay
  set Saturated material      = wet
  set Belt material           = clay
  set Saturated belt material = wet
  set Penalty ratio           = 30
  set Shear ratio             = 0.5
  set Fracture energy         = 12
  set Softening slip          = 2e-3
  set Damping ratio           = 0.02
  set Damping frequency       = 3
  set Stiffness correction    = false
  set Maximum iterations      = 25
  set Tolerance               = 1e-7
end
subsection Gravity
  set Acceleration = 9.8
end
subsection Water
  set Level = 175
end
subsection Motion
  set Type                = text
  set File                = record.txt
  set Unit                = cm/s2
  set Peak                = 9.81
  set Meaning             = incident
  set Angle               = 90
  set Start               = 0.5
  set Frequency           = 3
  set Lowest frequency    = 0.5
  set Highest frequency   = 9
  set Duration            = 20
  set Seed                = 7
  set Baseline correction = false
end
subsection Point loads
  set Forces    = left: 206, 134.6, 0, -1e10; right: 300, 150, 2e6, 3e6
  set Frequency = 12
  set Start     = 0.25
end
subsection Monitors
  set Points           = P1: 206, 134.6; P2: -3, 1e2
  set File             = points.csv
  set Names            = S2, S1
  set Base             = S1
  set Filter frequency = 20
end
subsection Boreholes
  set Lines    = ZK1: 288, 177, 288, 147; ZK2: 330, 190, 330, 164
  set Measured = ZK1: 0, 2.4, 7.6; ZK2: 8, 4.6
  set Samples  = 11
end
subsection Output
  set Directory        = out/full
  set Picture interval = 0.2
  set Flush interval   = 5
  set Audit interval   = 0.02
end
subsection Parallel
  set Threads = 2
end
)";

  void expect_full_scene(const SceneParameters &scene)
  {
    EXPECT_EQ(scene.title, "A slope with everything");
    EXPECT_EQ(scene.time.end_time, 12.5);
    EXPECT_EQ(scene.time.time_step, 5e-4);
    EXPECT_EQ(scene.time.maximum_halvings, 6);
    EXPECT_EQ(scene.time.scheme, "shi");
    EXPECT_EQ(scene.time.newmark.gamma, 1.);
    EXPECT_EQ(scene.time.newmark.beta, 0.5);
    EXPECT_EQ(scene.time.maximum_displacement_ratio, 0.001);
    EXPECT_EQ(scene.time.dynamic_coefficient, 0.98);
    ASSERT_EQ(scene.mesh.numbers.size(), 2u);
    EXPECT_EQ(scene.mesh.numbers[0], std::make_pair(std::string("Resolution/h"), 4.));
    EXPECT_EQ(scene.mesh.numbers[1], std::make_pair(std::string("Resolution/far"), 20.));
    EXPECT_TRUE(scene.has_continuum());
    EXPECT_TRUE(scene.blocks.enabled);
    EXPECT_FALSE(scene.blocks.bonded);
    EXPECT_EQ(scene.environment.gravity, 9.8);
    EXPECT_EQ(scene.environment.water_level, 175.);
    EXPECT_EQ(scene.output.directory, "out/full");
    EXPECT_EQ(scene.output.picture_interval, 0.2);
    EXPECT_EQ(scene.output.flush_interval, 5.);
    EXPECT_EQ(scene.output.audit_interval, 0.02);
    EXPECT_EQ(scene.threads, 2);
  }

  void expect_full_materials(const SceneParameters &scene)
  {
    ASSERT_EQ(scene.materials.size(), 3u);
    const Material &rock = scene.material("rock", "test");
    EXPECT_EQ(rock.name, "rock");
    EXPECT_EQ(rock.young_modulus, 60e9);
    EXPECT_EQ(rock.poisson_ratio, 0.2);
    EXPECT_EQ(rock.weighing_density(), 2450.);
    EXPECT_LT(rock.residual_friction_angle, 0.);
    const Material &wet = scene.material("wet", "test");
    EXPECT_EQ(wet.weighing_density(), 1320.);
    EXPECT_EQ(wet.friction_angle, 16.6);
    EXPECT_EQ(wet.residual_friction_angle, 12.);
    EXPECT_EQ(wet.cohesion, 40e3);
    EXPECT_EQ(wet.residual_cohesion, 10e3);
    EXPECT_EQ(scene.material("clay", "test").tensile_strength, 60e3);

    EXPECT_EQ(scene.continuum.degree, 3);
    EXPECT_EQ(scene.continuum.region_material.of("bedrock"), "rock");
    EXPECT_EQ(scene.continuum.region_material.of("bedrock_soil"), "clay");
    EXPECT_EQ(scene.continuum.base.name, rigid_base().name);
    EXPECT_EQ(scene.continuum.sides.name, free_field_side().name);
    EXPECT_EQ(scene.continuum.half_space_material, "rock");
    EXPECT_EQ(scene.continuum.rayleigh_mass, 0.1);
    EXPECT_EQ(scene.continuum.rayleigh_stiffness, 1e-4);
    EXPECT_EQ(scene.bedding.names, (std::vector<std::string>{"bedding_1", "bedding_2"}));
    EXPECT_EQ(scene.bedding.normal_stiffness, 1e10);
    EXPECT_EQ(scene.bedding.shear_stiffness, 2e9);
  }

  void expect_full_blocks(const BlockParameters &blocks)
  {
    EXPECT_EQ(blocks.material.of("sliding_mass"), "clay");
    EXPECT_EQ(blocks.saturated_material.in_words(), "wet");
    EXPECT_EQ(blocks.belt_material, "clay");
    EXPECT_EQ(blocks.saturated_belt_material, "wet");
    EXPECT_EQ(blocks.penalty_ratio, 30.);
    EXPECT_EQ(blocks.shear_ratio, 0.5);
    EXPECT_EQ(blocks.fracture_energy, 12.);
    EXPECT_EQ(blocks.softening_slip, 2e-3);
    EXPECT_EQ(blocks.damping_ratio, 0.02);
    EXPECT_EQ(blocks.damping_frequency, 3.);
    EXPECT_FALSE(blocks.stiffness_correction);
    EXPECT_EQ(blocks.maximum_iterations, 25);
    EXPECT_EQ(blocks.tolerance, 1e-7);
  }

  void expect_full_motion_and_monitors(const SceneParameters &scene)
  {
    const MotionParameters &motion = scene.motion;
    EXPECT_EQ(motion.type, "text");
    EXPECT_EQ(motion.file_unit, 0.01);
    EXPECT_EQ(motion.peak, 9.81);
    EXPECT_FALSE(motion.outcrop);
    EXPECT_EQ(motion.angle, 90.);
    EXPECT_EQ(motion.start, 0.5);
    EXPECT_EQ(motion.frequency, 3.);
    EXPECT_EQ(motion.lowest_frequency, 0.5);
    EXPECT_EQ(motion.highest_frequency, 9.);
    EXPECT_EQ(motion.duration, 20.);
    EXPECT_EQ(motion.seed, 7);
    EXPECT_FALSE(motion.baseline_correction);

    ASSERT_EQ(scene.point_loads.loads.size(), 2u);
    EXPECT_EQ(scene.point_loads.loads[0].name, "left");
    EXPECT_EQ(scene.point_loads.loads[0].position, Vec2(206., 134.6));
    EXPECT_EQ(scene.point_loads.loads[1].peak, Vec2(2e6, 3e6));
    EXPECT_EQ(scene.point_loads.frequency, 12.);
    EXPECT_EQ(scene.point_loads.start, 0.25);

    const std::vector<Monitor> &points = scene.monitors.monitors;
    ASSERT_EQ(points.size(), 4u);
    EXPECT_EQ(points[0].name, "P1");
    EXPECT_EQ(points[1].position, Vec2(-3., 100.));
    EXPECT_EQ(points[2].name, "S2"); // in the order of Names, not of the file
    EXPECT_EQ(points[2].position, Vec2(30., 40.));
    EXPECT_EQ(points[3].position, Vec2(10., 20.5));
    EXPECT_EQ(scene.monitors.base_monitor, "S1");
    EXPECT_EQ(scene.monitors.filter_frequency, 20.);
    ASSERT_EQ(scene.monitors.boreholes.size(), 2u);
    EXPECT_EQ(scene.monitors.boreholes[1].name, "ZK2");
    EXPECT_EQ(scene.monitors.boreholes[1].top, Vec2(330., 190.));
    EXPECT_EQ(scene.monitors.boreholes[1].bottom, Vec2(330., 164.));
    EXPECT_EQ(scene.monitors.boreholes[1].samples, 11);
    EXPECT_EQ(scene.monitors.boreholes[0].measured_error_mm, std::vector<double>{7.6});
    EXPECT_EQ(scene.monitors.boreholes[1].measured_mm, std::vector<double>{4.6});
    EXPECT_EQ(scene.monitors.boreholes[1].measured_error_mm, std::vector<double>{0.});
  }

  void expect_all_of_full_scene(const SceneParameters &scene)
  {
    expect_full_scene(scene);
    expect_full_materials(scene);
    expect_full_blocks(scene.blocks);
    expect_full_motion_and_monitors(scene);
  }
} // namespace

TEST_F(SceneReader, EveryParameterReachesItsMember)
{
  write("mesh/section.geo", "");
  write("record.txt", "0\n1\n0\n");
  write("points.csv", "# comment\npolyline,x,z\nground,0,1\nground,2,1\nS1,10,20.5\nS2,30,40\n");
  const SceneParameters scene = read_scene(write("full.prm", full_scene));
  expect_all_of_full_scene(scene);
  EXPECT_EQ(scene.mesh.file, path("mesh/section.geo"));
  EXPECT_EQ(scene.motion.file, path("record.txt"));
}

TEST_F(SceneReader, UsedParametersReadBackToTheSameScene)
{
  write("mesh/section.geo", "");
  write("record.txt", "0\n1\n0\n");
  write("points.csv", "S1,10,20.5\nS2,30,40\n");
  const SceneParameters scene = read_scene(write("full.prm", full_scene), {"Time/Scheme=shi"});
  const SceneParameters again = read_scene(write("elsewhere/used.prm", scene.used_prm));
  expect_all_of_full_scene(again);
  EXPECT_EQ(again.mesh.file, scene.mesh.file);
  EXPECT_EQ(again.motion.file, scene.motion.file);
  EXPECT_EQ(read_scene(write("elsewhere/used_again.prm", again.used_prm)).used_prm, again.used_prm);
}

TEST_F(SceneReader, SmallSceneKeepsTheDefaultsOfTheStructs)
{
  const SceneParameters scene = read_scene(write_scene());
  const SceneParameters standard;
  EXPECT_EQ(scene.time.time_step, standard.time.time_step);
  EXPECT_EQ(scene.time.newmark.beta, standard.time.newmark.beta);
  EXPECT_EQ(scene.blocks.tolerance, standard.blocks.tolerance);
  EXPECT_EQ(scene.environment.water_level, standard.environment.water_level);
  EXPECT_EQ(scene.motion.type, "none");
  EXPECT_EQ(scene.motion.peak, standard.motion.peak);
  EXPECT_EQ(scene.materials.at("clay").weight_density, Material().weight_density);
  EXPECT_TRUE(scene.blocks.enabled && scene.blocks.bonded);
  EXPECT_EQ(scene.continuum.region_material.of("bedrock"), "rock");
  const SceneParameters again = read_scene(write("used.prm", scene.used_prm));
  EXPECT_EQ(again.used_prm, scene.used_prm);
  EXPECT_EQ(again.environment.water_level, standard.environment.water_level);
}

TEST_F(SceneReader, WaterLevelNoneMeansNoWater)
{
  const std::string wet = write_scene("subsection Water\n  set Level = 145\nend\n");
  EXPECT_EQ(read_scene(wet).environment.water_level, 145.);
  EXPECT_LT(read_scene(wet, {"Water/Level=none"}).environment.water_level, -1e200);
}

TEST_F(SceneReader, PrintedParametersAreAValidFileWithHelpUnitAndRange)
{
  std::ostringstream text;
  print_all_parameters(text);
  const std::string flat =
    std::regex_replace(text.str(), std::regex("\\n *#"), ""); // joined comments
  for (const char *part : {"set Time step",
                           "a number > 0 [s]",
                           "one of compliant | rigid | fixed",
                           "true or false",
                           "subsection soil",
                           "set Level",
                           "set Threads"})
    EXPECT_NE(flat.find(part), std::string::npos) << part;
  write("section.geo", "");
  const SceneParameters scene =
    read_scene(write("all.prm", text.str()), {"Mesh/File=" + path("section.geo")});
  EXPECT_EQ(scene.materials.at("rock").young_modulus, 60e9);
  EXPECT_EQ(scene.blocks.material.in_words(), "soil");
  EXPECT_EQ(scene.time.end_time, TimeParameters().end_time);
}

TEST_F(SceneReader, OverridesReplaceValuesOfTheFile)
{
  const SceneParameters scene = read_scene(write_scene(),
                                           {"Materials/rock/Density=2700",
                                            "Time/End time = 3",
                                            "Time/End time=4",
                                            "Title=a = b",
                                            "Mesh/Numbers=Resolution/h = 2"});
  EXPECT_EQ(scene.materials.at("rock").density, 2700.);
  EXPECT_EQ(scene.time.end_time, 4.);
  EXPECT_EQ(scene.title, "a = b");
  EXPECT_EQ(scene.mesh.numbers.at(0).second, 2.);
  EXPECT_NE(scene.used_prm.find("2700"), std::string::npos);
}

TEST_F(SceneReader, FilesResolveAgainstTheFileThatNamesThem)
{
  write("common/meshes/slope.geo", "");
  write("common/model.prm", "subsection Mesh\n  set File = meshes/slope.geo\nend\n");
  const std::string file = write("runs/a.prm",
                                 "include ../common/model.prm\n"
                                 "subsection Model\n  set Bedrock = rigid\nend\n"
                                 "subsection Materials\n  set Names = clay\n  subsection clay\n"
                                 "    set Density = 2000\n  end\nend\n"
                                 "subsection Blocks\n  set Material = clay\nend\n");
  EXPECT_EQ(read_scene(file).mesh.file, path("common/meshes/slope.geo"));
}

TEST_F(SceneReader, AFileMaySetAgainWhatItsIncludedFilesSet)
{
  const std::string base =
    write_scene("subsection Water\n  set Level = 175\n  set Method = submerged\nend\n");
  const std::string variant =
    write("variant.prm",
          "include scene.prm\nsubsection Water\n  set Method = paper\nend\n"
          "subsection Materials\n  subsection clay\n    set Density = 1220\n  end\nend\n");
  EXPECT_EQ(read_scene(base).environment.water_method, WaterMethod::submerged);
  const SceneParameters scene = read_scene(variant);
  EXPECT_EQ(scene.environment.water_method, WaterMethod::paper);
  EXPECT_EQ(scene.environment.water_level, 175.);
  EXPECT_EQ(scene.materials.at("clay").density, 1220.);
}

TEST_F(SceneReader, PeaksMayHaveTheirUnit)
{
  const std::string file = write_scene();
  const auto        peak = [&](const std::string &value) {
    return read_scene(file, {"Motion/Type=sine", "Motion/Peak=" + value}).motion;
  };
  EXPECT_EQ(peak("0.3").peak, 0.3);
  EXPECT_FALSE(peak("0.3").peak_has_unit);
  EXPECT_DOUBLE_EQ(peak("0.3 g").peak, 0.3 * 9.80665);
  EXPECT_TRUE(peak("0.3g").peak_has_unit);
  EXPECT_EQ(peak("2.4e-1 m/s2").peak, 0.24);
  EXPECT_EQ(peak("24 cm/s2").peak, 0.24);
  EXPECT_EQ(peak("24 gal").peak, 0.24);
  EXPECT_EQ(read_scene(file, {"Motion/Unit=gal"}).motion.file_unit, 0.01);
  EXPECT_LT(peak("as recorded").peak, 0.);
  EXPECT_FALSE(peak("as recorded").file_unit_is_set);
  EXPECT_TRUE(read_scene(file, {"Motion/Unit=m/s2"}).motion.file_unit_is_set);
  EXPECT_NE(read_scene(file, {"Motion/Peak=0.3 g"}).used_prm.find("0.3 g"), std::string::npos);
}

TEST_F(SceneReader, BedrockOfEveryKind)
{
  write("slope.geo", "");
  const std::string file    = write("a.prm",
                                 "subsection Mesh\n  set File = slope.geo\nend\n"
                                    "subsection Materials\n  set Names = clay\n  subsection clay\n"
                                    "    set Density = 2000\n  end\nend\n"
                                    "subsection Continuum\n  set Materials = clay\nend\n"
                                    "subsection Blocks\n  set Material = clay\nend\n");
  const auto        bedrock = [&](const std::vector<std::string> &overrides) {
    return read_scene(file, overrides).bedrock;
  };
  EXPECT_EQ(bedrock({}).name, "continuum");
  EXPECT_EQ(bedrock({"Model/Bedrock=rigid"}).name, "rigid");
  const SceneParameters triangles = read_scene(file, {"Model/Bedrock=triangles"});
  EXPECT_FALSE(triangles.has_continuum());
  EXPECT_TRUE(triangles.has_bedrock_blocks());
  EXPECT_EQ(triangles.bedrock_material("bedrock_soft").name, "clay");
  EXPECT_TRUE(read_scene(file, {"Model/Bedrock=triangles", "Model/Blocks=none"}).has_blocks());
  write("used.prm", triangles.used_prm); // what a run writes is a scene by itself
  EXPECT_EQ(read_scene(path("used.prm")).bedrock.name, "triangles");
}

TEST_F(SceneReader, SidesHaveAFreeFieldWhereAMotionComesIn)
{
  const std::string file  = write_scene("subsection Bedding planes\n  set Names = plane\nend\n");
  const auto        sides = [&](const std::vector<std::string> &overrides) {
    return read_scene(file, overrides).continuum.sides.name;
  };
  const std::string shaken = "Motion/Type=sine";
  EXPECT_EQ(sides({shaken}), "free field");
  EXPECT_EQ(sides({shaken, "Continuum/Base=rigid"}), "free field");
  EXPECT_EQ(sides({shaken, "Model/Bedrock=triangles"}), "free field");
  EXPECT_EQ(sides({shaken, "Model/Bedrock=layers"}), "viscous");
  EXPECT_EQ(sides({shaken, "Continuum/Base=fixed"}), "viscous");
  EXPECT_EQ(sides({"Motion/Type=none"}), "viscous");
  EXPECT_EQ(sides({"Motion/Type=none", "Continuum/Sides=free field"}), "free field");
  EXPECT_EQ(sides({shaken, "Continuum/Sides=viscous"}), "viscous");
}

TEST_F(SceneReader, AutomaticSchemeDampsWhereSomethingSlides)
{
  const std::string file  = write_scene("subsection Bedding planes\n  set Names = plane\nend\n");
  const auto        gamma = [&](const std::vector<std::string> &overrides) {
    return read_scene(file, overrides).time.newmark.gamma;
  };
  const std::string none = "Model/Blocks=none", strength = "Bedding planes/Strength=Mohr-Coulomb";
  EXPECT_EQ(gamma({}), 0.6);
  EXPECT_EQ(gamma({none}), 0.5);
  EXPECT_EQ(gamma({none, strength}), 0.6);
  EXPECT_EQ(gamma({none, strength, "Bedding planes/Names="}), 0.5);
  EXPECT_EQ(gamma({none, "Model/Bedrock=triangles"}), 0.6);
  EXPECT_EQ(gamma({none, "Time/Scheme=shi"}), 1.);
  EXPECT_EQ(gamma({"Time/Scheme=trapezoidal"}), 0.5);
}

TEST_F(SceneReader, InertiaIsCorrectedForTheStepOfALinearScene)
{
  const std::string file = write_scene("subsection Bedding planes\n  set Names = plane\nend\n");
  const auto        step = [&](const std::vector<std::string> &overrides) {
    return read_scene(file, overrides).time.newmark.corrected_step;
  };
  const std::string none = "Model/Blocks=none", finer = "Time/Time step=5e-4";
  const std::string fourth   = "Time/Scheme=fourth order",
                    strength = "Bedding planes/Strength=Mohr-Coulomb";
  EXPECT_EQ(step({finer}), 0.);
  EXPECT_EQ(step({none, finer}), 5e-4);
  EXPECT_EQ(step({none, finer, fourth}), 5e-4);
  EXPECT_EQ(step({none, finer, "Time/Scheme=trapezoidal"}), 0.);
  EXPECT_THROW(step({fourth}), InputError);
  EXPECT_THROW(step({none, strength, fourth}), InputError);
}

TEST(SceneParameters, UnknownMaterialIsNamedWithItsPlaceAndASuggestion)
{
  SceneParameters scene;
  scene.materials["bedrock"].name = "bedrock";
  try
    {
      scene.material("bedrok", "Blocks/Material");
      FAIL() << "accepted";
    }
  catch (const InputError &error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find("Blocks/Material = 'bedrok'"), std::string::npos) << text;
      EXPECT_NE(text.find("did you mean 'bedrock'?"), std::string::npos) << text;
    }
}
