// SPDX-License-Identifier: GPL-3.0-or-later
#include "ended_run.h"

#include <hybrid/output/error_text.h>

#include <gtest/gtest.h>

namespace hybrid::output
{
  namespace
  {
    Summary told_by_two_runs()
    {
      Summary                 run   = a_run();
      Summary::ProbableError &error = run.probable_error;
      error.reason                  = "";
      error.measured_from           = 5e-4;
      error.step.part               = {{0.04, 0.1, 0.5}};
      error.half_step.part          = {{0.02, 0.05, 0.2}}; // by order
      error.step.where              = {{"a", "b", "b"}};
      error.cost                    = 10.;
      return run;
    }



    TEST(ErrorText, SaysTheProbableErrorAndOnTheScreenWhatHalfTheStepCosts)
    {
      Summary                 run   = a_run();
      Summary::ProbableError &error = run.probable_error;
      error.reason                  = "";
      error.step.part               = {{4.3e-3, 0.0171, 3.}};
      error.step.where              = {{"crest", "toe", "toe"}};
      error.half_step.part          = {{1.1e-3, 4.2e-3, 1e-7}};
      error.cost                    = 84.;
      const scene::SceneParameters scene;
      const EndText                text = end_text(run, scene);
      const std::string            line =
        "\nError     of the time step, probably: displacement 0.43 % of the peak (crest), velocity "
        "1.7 % (toe), acceleration over 100 % (toe); with half the step 0.11, 0.42, below 0.05 %";
      EXPECT_EQ(text.in_file.substr(text.in_file.find("\nError")), line);
      EXPECT_NE(text.on_screen.find(line + " for at most 84 s more of processor time\n"),
                std::string::npos);
      error.mesh.part  = {{1e-3, 2e-3, MonitorSummary::unknown}};
      error.mesh.where = {{"base", "base", ""}};
      EXPECT_NE(
        end_text(run, scene)
          .in_file.find(
            line +
            "\n          of the bedrock's mesh, waves alone, at least: displacement 0.1 % of the peak (base), "
            "velocity 0.2 % (base)"),
        std::string::npos);
      const std::string corners = "; what its corners and bends leave is not in it";
      EXPECT_EQ(end_text(run, scene).in_file.find(corners), std::string::npos);
      error.mesh_has_corners = true;
      EXPECT_NE(end_text(run, scene).in_file.find("0.2 % (base)" + corners), std::string::npos);
      run.mesh_error.follows = true; // and tells them
      EXPECT_EQ(end_text(run, scene).in_file.find(corners), std::string::npos);
      error.until = 2.345;
      EXPECT_NE(end_text(run, scene).in_file.find("probably, until a joint failed at 2.345 s: dis"),
                std::string::npos);
      error.reason = "bedding planes slip or open";
      EXPECT_NE(end_text(run, scene)
                  .in_file.find(
                    "\nError     of the time step: not estimated, bedding planes slip or open"),
                std::string::npos);
      error.runs_would_do = true;
      error.second_step   = 0.002;
      EXPECT_EQ(error_text(run).on_screen,
                "Error     of the time step: not estimated, bedding planes slip or open; the scene "
                "once more in steps of 0.002 s tells it, below");
    }



    TEST(ErrorText, SaysWhenAJointFailedInTheOtherRun)
    {
      Summary                 run   = a_run();
      Summary::ProbableError &error = run.probable_error;
      error.reason                  = "";
      error.step.part[0]            = 0.01;
      error.until                   = 1.64;
      error.until_later             = 1.64;
      error.measured_from           = 2e-3;
      const auto says               = [&](const std::string &words) {
        return error_text(run).in_file.find("until a joint failed " + words + ": displacement") !=
               std::string::npos;
      };
      EXPECT_TRUE(says("at 1.64 s"));
      error.until_later = 1.647;
      EXPECT_TRUE(says("at 1.64 s (at 1.647 s in the other run)"));
      error.until_later = MonitorSummary::unknown;
      EXPECT_TRUE(says("at 1.64 s (not yet in the other run)"));
      error.failed_in_other = true;
      EXPECT_TRUE(says("in the other run at 1.64 s (not yet in this one)"));
      error.failed_in_other = false;
      error.measured_from   = MonitorSummary::unknown; // there is no other run
      EXPECT_TRUE(says("at 1.64 s"));
    }



    TEST(ErrorText, SaysWhatWasWatchedWithoutMonitors)
    {
      Summary run = a_run();
      run.monitors.clear();
      Summary::ProbableError &error = run.probable_error;
      EXPECT_EQ(error_text(run).on_screen, ""); // nothing moved, or no step was taken
      error.watched = "8 blocks and 4 points of the bedrock";
      EXPECT_EQ(error_text(run).in_file,
                "Error     of the time step at 8 blocks and 4 points of the bedrock, as there are "
                "no monitors: not estimated, blocks");
      error.reason          = "";
      error.step.part[1]    = 0.01;
      error.step.where[1]   = "x_3_y_4";
      error.half_step.part  = {{MonitorSummary::unknown, 2.5e-3, MonitorSummary::unknown}};
      const std::string end = ", probably: velocity 1 % of the peak (x_3_y_4); with half the step";
      EXPECT_NE(error_text(run).in_file.find("as there are no monitors" + end), std::string::npos);
      EXPECT_NE(end_text(run, {}).on_screen.find("hybrid accuracy"), std::string::npos);
    }



    TEST(ErrorText, SaysWhereAnAccelerationIsLargestWhereNothingIsTold)
    {
      Summary                 run   = a_run();
      Summary::ProbableError &error = run.probable_error;
      error.reason                  = "";
      error.measured_from           = 5e-4;
      error.step.part[2]            = 0.1;
      EXPECT_EQ(error_text(run).in_file.find("an end of the record"), std::string::npos);
      error.peak_at_end = "crest";
      error.cost        = 84.;
      EXPECT_NE(error_text(run).on_screen.find("of processor time; the acceleration of crest is"),
                std::string::npos);
      EXPECT_NE(error_text(run).in_file.find("; the acceleration of crest is largest at an end of "
                                             "the record, where nothing is filtered nor told"),
                std::string::npos);
    }



    TEST(ErrorText, SaysWhyNothingTellsTheErrorOfAMesh)
    {
      Summary run          = a_run();
      run.mesh_error.never = "the blocks are given as polygons, which cannot be made coarser";
      const std::string line =
        "\n          of the mesh: not told, the blocks are given as polygons, which cannot be made "
        "coarser\nResults";
      EXPECT_NE(end_text(run, {}).on_screen.find(line), std::string::npos);
      EXPECT_EQ(end_text(run, {}).on_screen.find("hybrid accuracy"), std::string::npos);
    }



    TEST(ErrorText, SaysThatBlocksStrikeEachOther)
    {
      Summary                 run   = told_by_two_runs();
      Summary::ProbableError &error = run.probable_error;
      error.blocks_strike           = true;
      EXPECT_EQ(
        error_text(run).in_file,
        "Error     of the time step, by the run in steps of 0.0005 s: displacement 4 % of the "
        "peak (a), velocity 10 % (b), acceleration 50 % (b); half the step leaves as much; "
        "blocks strike each other, runs in other steps may go another way");
      EXPECT_EQ(error_text(run).on_screen, error_text(run).in_file); // no price
      error.blocks_strike = false;
      EXPECT_NE(error_text(run).in_file.find("with half the step 2, 5, 20 %"), std::string::npos);
      error.step.part[2] = error.half_step.part[2] = MonitorSummary::unknown;
      EXPECT_NE(error_text(run).in_file.find("with half the step 2, 5 %"), std::string::npos);
      error.half_step = error.step;
      EXPECT_NE(error_text(run).in_file.find("this is how far they scatter"), std::string::npos);
    }



    TEST(ErrorText, SaysThatBlocksMayFlutter)
    {
      Summary                 run   = told_by_two_runs();
      Summary::ProbableError &error = run.probable_error;
      error.may_flutter             = true;
      EXPECT_EQ(
        error_text(run).in_file,
        "Error     of the time step, by the run in steps of 0.0005 s: displacement 4 % of the "
        "peak (a), velocity 10 % (b), acceleration 50 % (b); with half the step 2, 5, 20 %; at "
        "least, as blocks with little damping slide, and may flutter in yet shorter steps "
        "(Blocks/Damping ratio)");
    }



    TEST(ErrorText, SaysTheErrorOfTheMeshAndWhereNoOrderIsSeen)
    {
      Summary::MeshError error;
      error.reason           = "";
      error.meshes           = 2;
      error.size.part        = {{0.2, 0.3, 0.4}};
      error.size.where       = {{"crest", "toe", "toe"}};
      error.half_size.part   = {{0.1, 0.15, 0.2}};
      error.cost             = 200.;
      const std::string line = "Error     of the mesh, by those twice and four times as large: "
                               "displacement 20 % of the peak (crest), velocity 30 % (toe), "
                               "acceleration 40 % (toe)";
      error.order_is_seen    = true;
      EXPECT_EQ(mesh_error_text(error).in_file, line + "; with half the size 10, 15, 20 %");
      EXPECT_EQ(mesh_error_text(error).on_screen,
                line + "; with half the size 10, 15, 20 % in at least 200 s of processor time");
      error.order_is_seen = false;
      EXPECT_EQ(mesh_error_text(error).on_screen,
                line + "; with half the size 10, 15, 20 % in at least 200 s of processor time, "
                       "roughly: no order is seen in these meshes");
      error.order_is_seen = error.keeps_corners = true;
      EXPECT_EQ(mesh_error_text(error).in_file,
                line +
                  "; with half the size 10, 15, 20 %; at least, as cells at inward corners are "
                  "as large in all of them (Mesh/Corner levels)");
      error.of_corners = true;
      EXPECT_EQ(
        mesh_error_text(error).in_file,
        "Error     of the mesh, by those twice and four times as large and smaller cells at "
        "inward corners: displacement 20 % of the peak (crest), velocity 30 % (toe), "
        "acceleration 40 % (toe); with half the size 10, 15, 20 %");
      error.reason = "the next mesh is hardly coarser";
      EXPECT_EQ(mesh_error_text(error).on_screen,
                "Error     of the mesh: not known, the next mesh is hardly coarser");
    }
  } // namespace
} // namespace hybrid::output
