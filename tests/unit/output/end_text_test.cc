// SPDX-License-Identifier: GPL-3.0-or-later
#include "ended_run.h"

#include <hybrid/output/end_text.h>

#include <gtest/gtest.h>

namespace hybrid::output
{
  namespace
  {
    TEST(EndText, SaysHowFarAndWhatItFoundAndTheFileHasNoTimes)
    {
      scene::SceneParameters scene;
      scene.output.directory      = "output/slope";
      scene.monitors.base_monitor = "base";
      const EndText     text      = end_text(a_run(), scene);
      const std::string found =
        ", 15000 steps, 0 cuts, energy residual 5.0e-08"
        "\n          crest  peak -16.1 mm along x, -10.6 mm at the end, peak acceleration 0.43 g along x = 1.49 x outcrop"
        "\n          slip on the sliding surface: 10.1 mm left (largest 10.3 mm), 50 % of it slipped "
        "by more than 1 mm; no joint failed"
        "\n          shear strength of the sliding surface: 70 % mobilised at rest, at most 100 %, at "
        "the end 65 %"
        "\nError     of the time step: not estimated, blocks";
      EXPECT_EQ(text.in_file, "Finished  15 s" + found);
      EXPECT_EQ(
        text.on_screen,
        "Finished  15 s in 4:07" + found +
          "\n          of the mesh of blocks: hybrid accuracy output/slope finds it by coarser "
          "runs\nResults   output/slope   next: hybrid plot output/slope");
    }



    TEST(EndText, SaysWhichPlanesHaveSlippedAndOpened)
    {
      Summary run = a_run();
      run.blocks  = 0;
      run.planes  = {{"bedding_1", {-0.2814, {{12.5, 7.}}, 0.}},
                     {"bedding_2", {2e-7, {{1., 2.}}, 3e-7}},
                     {"bedding_3", {0.0021, {{3., 4.}}, 0.004}},
                     {"bedding_4", {0., {{5., 6.}}, 0.0123}}};
      EXPECT_NE(
        end_text(run, {}).in_file.find(
          "\n          bedding_1  has slipped by 281 mm at most, at (12.5, 7) m"
          "\n          bedding_3  has slipped by 2.1 mm at most, at (3, 4) m; it is open by "
          "4 mm at most"
          "\n          bedding_4  is open by 12.3 mm at most\n"),
        std::string::npos)
        << end_text(run, {}).in_file;
    }



    TEST(EndText, SaysThatDashpotsGiveWayToSlipAndToWater)
    {
      const auto told = [](const double slip, const scene::SceneParameters &scene) {
        Summary run = a_run();
        run.planes  = {{"bedding_1", {slip, {{12.5, 7.}}, 0.}}};
        return end_text(run, scene).in_file.find("Boundary springs") != std::string::npos;
      };
      scene::SceneParameters scene;
      scene.continuum.base.is_compliant = true;
      EXPECT_TRUE(told(1e-3, scene));
      EXPECT_FALSE(told(1e-7, scene));
      scene.continuum.boundary_springs = true;
      EXPECT_FALSE(told(1e-3, scene));
      scene.continuum.boundary_springs          = false;
      scene.environment.water_tables.level_file = "level.csv";
      EXPECT_TRUE(told(0., scene));
      scene.continuum.base.is_compliant = false;
      EXPECT_FALSE(told(1e-3, scene));
    }



    TEST(EndText, SaysWhichBlocksHaveNothingBelowThem)
    {
      Summary run = a_run();
      EXPECT_EQ(end_text(run, {}).in_file.find("beyond"), std::string::npos);
      run.blocks_off_base = 1;
      EXPECT_NE(end_text(run, {}).in_file.find(
                  "\n          1 block is beyond the end of the base, where nothing is below\n"),
                std::string::npos);
      run.blocks_off_base = 12;
      EXPECT_NE(end_text(run, {}).in_file.find(
                  "\n          12 blocks are beyond the end of the base, where nothing is below\n"),
                std::string::npos);
    }



    TEST(EndText, SaysWhatSlipCountsWhereMassesFaceEachOtherAndBlocksFly)
    {
      Summary run = a_run();
      EXPECT_EQ(end_text(run, {}).in_file.find("touch"), std::string::npos);
      run.slip.downhill    = "both ways";
      run.slip.off_surface = 1;
      EXPECT_NE(
        end_text(run, {}).in_file.find(
          "no joint failed"
          "\n          slides lie on both flanks: the slip of each is positive its own way "
          "downhill"
          "\n          1 block touches the surface no more at the end: how far it has moved "
          "counts as slip\n"),
        std::string::npos);
      run.slip.off_surface = 3;
      EXPECT_NE(end_text(run, {}).in_file.find(
                  "\n          3 blocks touch the surface no more at the end: how far they have "
                  "moved counts as slip\n"),
                std::string::npos);
    }



    TEST(EndText, AMassThatIsHeldHasMobilisedNothingAtRest)
    {
      Summary run                      = a_run();
      run.base_shear.mobilised_at_rest = MonitorSummary::unknown;
      EXPECT_NE(end_text(run, {}).in_file.find(
                  "sliding surface: at most 100 % mobilised, at the end 65 %"),
                std::string::npos);
    }



    TEST(EndText, LeavesOutWhatARunDoesNotHave)
    {
      Summary run;
      run.steps = 3, run.simulated_time = 0.5, run.wall_time = 3723.;
      scene::SceneParameters scene;
      scene.time.end_time = 2.;
      EXPECT_EQ(end_text(run, scene).in_file,
                "Stopped   at 0.5 s of 2 s, 3 steps, 0 cuts, energy residual 0.0e+00");
      EXPECT_NE(end_text(run, scene).on_screen.find(" in 1:02:03,"), std::string::npos);
      run.blocks             = 2;
      run.joints.tensile     = 1;
      const std::string text = end_text(run, scene).in_file;
      EXPECT_EQ(text.substr(text.find('\n') + 1), "          1 joint failed (1 tensile, 0 shear)");
    }
  } // namespace
} // namespace hybrid::output
