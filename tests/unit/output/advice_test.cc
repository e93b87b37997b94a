// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/advice.h>

#include <gtest/gtest.h>

#include "block_scenes.h"

namespace hybrid::output
{
  TEST(Advice, RoundsDownToTwoDigits)
  {
    EXPECT_EQ(rounded_down(0.0123), 0.012);
    EXPECT_EQ(rounded_down(0.00999), 0.0099);
    EXPECT_EQ(rounded_down(1.99), 1.9);
    EXPECT_EQ(rounded_down(1672.), 1600.);
    for (const double value : {3e-7, 0.004, 0.29, 3.3, 17., 123., 9.9e9})
      {
        EXPECT_LE(rounded_down(value), value);
        EXPECT_GT(rounded_down(value), 0.9 * value);
      }
  }


  TEST(Advice, NamesTheSizeOfCells)
  {
    const Resolution continuum = {ModelPart::continuum, 2., 199.95, 0., 0., 5.};
    EXPECT_EQ(mesh_warning(continuum, 10.),
              "the continuum resolves 2 Hz at ten points per wave length, the motion has energy up "
              "to 10 Hz; cells of at most 3.9 m would do");
    EXPECT_EQ(mesh_warning(continuum, 2.), "");
    EXPECT_EQ(mesh_warning({ModelPart::mass, 5., 400., 2., 8., 10.}, 8.),
              "the sliding mass resolves 5 Hz at ten points per wave length, the motion has energy "
              "up to 8 Hz; blocks of at most 5 m would do");
  }


  TEST(Advice, NamesTheStep)
  {
    EXPECT_EQ(
      step_warning(0.01, 9.3),
      "the time step 0.01 s has fewer than 20 points per period of 9.3 Hz; 0.0053 s would do");
    EXPECT_EQ(step_warning(0.0053, 9.3), "");
    EXPECT_EQ(step_warning(1., 0.), ""); // no motion
  }


  TEST(Advice, TellsWhereExplicitStepsTakeTooManyParts)
  {
    EXPECT_EQ(parts_warning(15), "");
    EXPECT_EQ(
      parts_warning(98000).find("an explicit step takes 98000 stable parts, more than the 15"), 0u);
  }


  TEST(Advice, NamesTheRangeOfPenalties)
  {
    scene::SceneParameters scene;
    scene.blocks.material                 = "rock";
    scene.materials["rock"].poisson_ratio = 0.25;
    const auto with                       = [&](const double ratio) {
      scene.blocks.penalty_ratio = ratio;
      return penalty_warning(scene);
    };
    EXPECT_EQ(with(40.), "");
    EXPECT_NE(with(7.9).find("the penalty ratio 7.9 makes contacts and joints so soft"),
              std::string::npos);
    EXPECT_NE(with(1601.).find("; 8 to 1600 would do"), std::string::npos);
    EXPECT_EQ(with(8.), "");
    EXPECT_EQ(with(1600.), "");
    scene.materials["rock"].poisson_ratio = 0.499; // joints must be much stiffer than E
    EXPECT_NE(with(40.), "");
    EXPECT_EQ(with(4e4), "");
    scene.blocks.enabled = false;
    EXPECT_EQ(with(1.1), "");
  }


  TEST(Advice, NamesAWaveOnTheBoundary)
  {
    EXPECT_EQ(wave_warning(0., Vec2(0., 0.)), "");
    EXPECT_EQ(wave_warning(0.009, Vec2(0., 0.)), "");
    EXPECT_NE(wave_warning(0.25, Vec2(1200., 0.)).find("25 % of its amplitude at (1200, 0) m"),
              std::string::npos);
  }


  TEST(Advice, NamesTheStepOfFastBlocks)
  {
    scene::SceneParameters scene    = test::block_parameters(30.);
    scene.blocks.initial_velocities = {{"ball", Vec2(0., 0.), Vec2(2., 2.), Vec2(30., 40.), 25.}};
    const auto model                = dda::build_model(test::square_blocks(1, 1, 2.), scene, {});
    EXPECT_EQ(speed_warning(model, 1e-3), ""); // (50 / 2 + 25) dt = 0.05
    EXPECT_NE(
      speed_warning(model, 2e-3).find("moves by 0.1 of its size in a step, allowed is 0.05"),
      std::string::npos);
    EXPECT_NE(speed_warning(model, 2e-3).find("; 0.001 s would do"), std::string::npos);
    scene.blocks.initial_velocities.clear();
    EXPECT_EQ(speed_warning(dda::build_model(test::square_blocks(1, 1, 2.), scene, {}), 10.), "");
  }


  TEST(Advice, NamesTooManyThreadsAndPictures)
  {
    EXPECT_EQ(threads_warning(2, 2), "");
    EXPECT_EQ(threads_warning(2, 0), ""); // unknown
    EXPECT_NE(threads_warning(1000, 2).find(
                "Parallel/Threads = 1000 is more than the 2 processors"),
              std::string::npos);
    EXPECT_EQ(processes_warning(1, 4, 2), ""); // threads_warning() says so
    EXPECT_EQ(processes_warning(2, 2, 4), "");
    EXPECT_EQ(processes_warning(8, 2, 0), ""); // unknown
    EXPECT_NE(processes_warning(4, 1, 2).find("4 processes on a machine of 2 processors"),
              std::string::npos);
    EXPECT_NE(processes_warning(2, 2, 2).find("2 processes of 2 threads"), std::string::npos);
    scene::OutputParameters output;
    scene::TimeParameters   time;
    time.end_time           = 12.;
    output.picture_interval = 0.05;
    EXPECT_EQ(pictures_warning(output, time), "");
    output.picture_interval = 1e-9; // one per step
    EXPECT_NE(pictures_warning(output, time).find("makes 12000 pictures of each part; 0.024 s"),
              std::string::npos);
    output.picture_interval = 0.;
    EXPECT_EQ(pictures_warning(output, time), "");
  }


  TEST(Advice, NamesTheSizeThatResolvesFracture)
  {
    // Badong: 60 kPa, 49.92 MPa, 10 J/m2: 0.1387 m, and a block of 4 m stores 144 J/m2
    scene::SceneParameters scene             = test::block_parameters(27., 49.92e6);
    scene.blocks.bonded                      = true;
    scene.blocks.fracture_energy             = 10.;
    scene.materials["rock"].tensile_strength = 60e3;
    const auto with                          = [&scene](const double size) {
      scene::SectionMesh mesh = test::square_blocks(2, 1, size);
      mesh.lines["sliding_surface"].push_back({0, 1});
      return fracture_warning(
        scene, dda::build_model(mesh, scene, test::straight_foundation(0., 0., 2. * size, 2)));
    };
    EXPECT_EQ(
      with(4.),
      "tensile fracture of 'rock' is not resolved: blocks of 4 m store 144 J/m2 when a joint "
      "breaks, Blocks/Fracture energy is 10 J/m2, so that it is effectively brittle; blocks "
      "of at most 0.13 m (E G_f / F_t^2) would resolve it");
    scene.materials["belt"]                  = scene.materials["rock"];
    scene.materials["belt"].tensile_strength = 30e3;
    scene.blocks.belt_material               = "belt";
    EXPECT_NE(with(4.).find("fracture of 'rock' is"), std::string::npos);
    EXPECT_NE(with(4.).find("; nor is that of 'belt' (36.1 J/m2, at most 0.55 m)"),
              std::string::npos);
    scene.blocks.belt_material = "";
    EXPECT_EQ(with(0.13), "");
    EXPECT_NE(with(0.15), "");
    scene.blocks.fracture_energy = 0.; // brittle is what the user wants
    EXPECT_EQ(with(4.), "");
    scene.blocks.fracture_energy             = 10.;
    scene.materials["rock"].tensile_strength = 1e9; // never breaks
    EXPECT_EQ(with(4.), "");
    scene.materials["rock"].tensile_strength = 60e3;
    scene.materials["flat"]                  = scene.materials["rock"]; // no joint is of it
    scene.materials["flat"].tensile_strength = 90e3;
    scene.blocks.joint_materials             = scene::RegionMaterials::parse("joint_flat: flat");
    EXPECT_NE(with(4.), "");
    EXPECT_EQ(with(4.).find("flat"), std::string::npos);
    scene.blocks.bonded = false;
    EXPECT_EQ(with(4.), "");
  }


  TEST(Advice, ABeltThatBondsNothingIsToldOf)
  {
    scene::SceneParameters scene = test::block_parameters(30.);
    scene.materials["belt"]      = scene.materials["rock"];
    scene.blocks.belt_material   = "belt";
    scene::SectionMesh mesh      = test::square_blocks(2, 1);
    const auto         said      = [&]() {
      return belt_warning(scene,
                          dda::build_model(mesh, scene, test::straight_foundation(0., 0., 2., 2)));
    };
    EXPECT_EQ(said().find("Blocks/Belt material = belt bonds nothing"), 0u) << said();
    mesh.lines["sliding_surface"].push_back({0, 1});
    EXPECT_EQ(said(), "");
    scene.blocks.belt_material.clear();
    EXPECT_EQ(said(), "");
  }


  TEST(Advice, ABrakeOfAbsoluteVelocitiesDragsOnGroundThatMoves)
  {
    scene::SceneParameters scene = test::block_parameters(30.);
    scene.time.time_step         = 1e-3;
    const auto with              = [&scene](const double k01, const char *motion) {
      scene.time.dynamic_coefficient = k01;
      scene.motion.type              = motion;
      return drag_warning(scene);
    };
    EXPECT_EQ(with(1., "ricker"), "");
    EXPECT_EQ(with(0.98, "none"), "");
    EXPECT_NE(
      with(0.98, "ricker").find("Time/Dynamic coefficient = 0.98 brakes absolute velocities"),
      std::string::npos);
    EXPECT_NE(with(0.98, "ricker").find("a drag of 20 1/s"), std::string::npos);
  }
} // namespace hybrid::output
