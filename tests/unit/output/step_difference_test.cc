// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/step_difference.h>

#include "shaken_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    Summary::ProbableError unknown_error()
    {
      Summary::ProbableError error;
      error.reason        = "friction takes 30 % of the energy that is lost";
      error.runs_would_do = true;
      return error;
    }



    TEST(StepDifference, is_the_largest_over_the_peak)
    {
      const Summary::ErrorPart difference =
        step_difference(run_with(4e-3, 0.03), run_with(2e-3, 0.01));
      EXPECT_NEAR(difference.part[0], 0.02 / 1.01, 1e-4);
      EXPECT_EQ(difference.where[0], "point");
    }



    TEST(StepDifference, of_one_run_with_itself_is_zero)
    {
      const Summary::ErrorPart difference = step_difference(run_with(4e-3, 0.), run_with(4e-3, 0.));
      for (int q = 0; q < 3; ++q)
        EXPECT_EQ(difference.part[q], 0.);
    }



    TEST(StepDifference, does_not_see_what_alternates_from_step_to_step)
    {
      const StepRecord longer = run_with(4e-3, 0.);
      StepRecord       rings  = run_with(1e-3, 0.);
      for (std::size_t i = 500; i < 1500; ++i)
        rings.monitors[0].histories[2][2 * i] += i % 2 == 0 ? 100. : -100.; // peak 39
      EXPECT_LT(step_difference(longer, rings).part[2], 0.1);               // 2.5 unfiltered
    }



    TEST(StepDifference, of_accelerations_leaves_out_the_ends_where_nothing_is_filtered)
    {
      const StepRecord run   = run_with(4e-3, 0.02);
      StepRecord       jumps = run_with(2e-3, 0.01); // 20 at the last step: half the peak
      jumps.monitors[0].histories[2][2 * (jumps.time.size() - 1)] += 20.;
      const Summary::ErrorPart difference = step_difference(run, jumps);
      EXPECT_NEAR(difference.part[2], 0.01 / 1.01, 1e-3);
      jumps.monitors[0].histories[2][2 * (jumps.time.size() - 41)] += 2000.; // 0.08 s before
      EXPECT_GT(step_difference(run, jumps).part[2], 0.5);
      StepRecord unfiltered = run_with(2e-3, 0.01), longer = run;
      unfiltered.corner = longer.corner = 0.;
      unfiltered.monitors[0].histories[2][2 * (unfiltered.time.size() - 3)] += 20.;
      EXPECT_GT(step_difference(longer, unfiltered).part[2], 0.4);
    }



    TEST(StepDifference, leaves_out_what_moves_less_than_the_record_says)
    {
      StepRecord longer = run_with(4e-3, 0.02), shorter = run_with(2e-3, 0.01);
      for (StepRecord *record : {&longer, &shorter})
        record->monitors.push_back({"quiet", record->monitors[1].histories}); // the base's motion
      for (StepRecord *record : {&longer, &shorter})
        for (std::size_t i = 0; i < record->time.size(); ++i)
          record->monitors[2].histories[0][2 * i] += 0.05 * std::sin(3. * record->time[i]);
      for (double &x : longer.monitors[2].histories[0])
        x += 0.02; // of its peak 40 %
      EXPECT_GT(step_difference(longer, shorter).part[0], 0.3);
      shorter.least_motion = 0.1;
      EXPECT_LT(step_difference(longer, shorter).part[0], 0.02);
    }



    TEST(StepDifference, tells_of_a_peak_where_nothing_is_filtered)
    {
      StepRecord             run   = run_with(4e-3, 0.02);
      Summary::ProbableError error = unknown_error();
      measure_error_by_shorter_steps(run, run_with(2e-3, 0.01), error);
      EXPECT_EQ(error.peak_at_end, "");
      for (std::size_t i = run.time.size() - 4; i < run.time.size(); ++i)
        run.monitors[0].histories[2][2 * i] += 120.; // peak 40
      error = unknown_error();
      measure_error_by_shorter_steps(run, run_with(2e-3, 0.01), error);
      EXPECT_EQ(error.peak_at_end, "point");
    }



    TEST(StepDifference, ends_with_the_first_failure)
    {
      StepRecord longer = run_with(4e-3, 0.), shorter = run_with(2e-3, 0.);
      for (std::size_t i = 0; i < shorter.time.size(); ++i)
        if (shorter.time[i] > 1.2)
          shorter.monitors[0].histories[0][2 * i] += 1.;
      EXPECT_GT(step_difference(longer, shorter).part[0], 0.3);
      longer.until = 1.;
      EXPECT_LT(step_difference(longer, shorter).part[0], 1e-3);
    }



    TEST(StepDifference, of_two_runs_is_the_error_between_first_and_second_order)
    {
      StepRecord             shorter = run_with(2e-3, 0.02);
      Summary::ProbableError error   = unknown_error();
      measure_error(run_with(4e-3, 0.04), shorter, error);
      EXPECT_EQ(error.reason, "");
      EXPECT_EQ(error.measured_from, 4e-3);
      EXPECT_NEAR(error.step.part[0], 0.02 / std::sqrt(3.), 5e-4);
      EXPECT_NEAR(error.half_step.part[0], 0.02 / std::sqrt(3.) / (1. + std::sqrt(3.)), 3e-4);
    }



    TEST(StepDifference, to_half_the_step_is_the_error_of_either_order_but_for_a_fifth)
    {
      for (const double p : {1., 2.})
        {
          const double           left  = std::pow(0.5, p); // of the error
          const StepRecord       run   = run_with(4e-3, 0.02);
          Summary::ProbableError error = unknown_error();
          measure_error_by_shorter_steps(run, run_with(2e-3, 0.02 * left), error);
          EXPECT_EQ(error.reason, "");
          EXPECT_EQ(error.measured_from, 2e-3);
          EXPECT_NEAR(error.step.part[0], 0.02, 0.22 * 0.02);
          EXPECT_NEAR(error.half_step.part[0], 0.02 * left, 0.75 * 0.02 * left);
        }
    }



    TEST(StepDifference, to_half_the_step_tells_nothing_where_steps_are_cut)
    {
      StepRecord             shorter = run_with(2e-3, 0.02);
      Summary::ProbableError error   = unknown_error();
      shorter.step                   = 1e-3;
      measure_error_by_shorter_steps(run_with(2e-3, 0.01), shorter, error);
      EXPECT_FALSE(error.runs_would_do);
      EXPECT_NE(error.reason.find("steps are cut"), std::string::npos);
    }



    /// Twice as many steps from a time on.
    StepRecord with_cuts(const StepRecord &run, const double from)
    {
      StepRecord result = run;
      result.time.clear();
      for (StepRecord::Monitor &monitor : result.monitors)
        monitor.histories = {};
      for (std::size_t i = 0; i < run.time.size(); ++i)
        for (int part = i > 0 && run.time[i - 1] >= from ? 0 : 1; part < 2; ++part)
          {
            result.time.push_back(run.time[i] - (part == 0 ? 0.5 * run.step : 0.));
            for (std::size_t m = 0; m < run.monitors.size(); ++m)
              for (int q = 0; q < 3; ++q)
                for (int c = 0; c < 2; ++c)
                  result.monitors[m].histories[q].push_back(
                    run.monitors[m].histories[q][2 * i + c]);
          }
      return result;
    }



    TEST(StepDifference, tells_nothing_where_a_twentieth_of_the_time_went_in_the_same_steps)
    {
      const StepRecord longer = run_with(4e-3, 0.02), shorter = run_with(2e-3, 0.01);
      const double     end = longer.time.back();
      for (const double part : {0.03, 0.1})
        {
          Summary::ProbableError error = unknown_error();
          measure_error_by_shorter_steps(with_cuts(longer, (1. - part) * end), shorter, error);
          EXPECT_TRUE(error.runs_would_do); // yet shorter ones
          EXPECT_EQ(error.reason,
                    part < 0.05
                      ? ""
                      : "steps are cut, and for 10 % of the time both runs take the same");
          error = unknown_error(); // the other is cut as well
          measure_error_by_shorter_steps(with_cuts(longer, (1. - part) * end),
                                         with_cuts(shorter, (1. - part) * end),
                                         error);
          EXPECT_EQ(error.reason, "");
        }
    }



    TEST(StepDifference, tells_when_a_joint_failed_in_the_other_run)
    {
      StepRecord             run = run_with(4e-3, 0.02), shorter = run_with(2e-3, 0.01);
      Summary::ProbableError error = unknown_error();
      measure_error_by_shorter_steps(run, shorter, error);
      EXPECT_TRUE(std::isnan(error.until) && std::isnan(error.until_later));
      run.until = 1.2;
      measure_error_by_shorter_steps(run, shorter, error);
      EXPECT_EQ(error.until, 1.2);
      EXPECT_TRUE(std::isnan(error.until_later));
      shorter.until = 1.204; // a step of the run
      measure_error_by_shorter_steps(run, shorter, error);
      EXPECT_EQ(error.until_later, error.until);
      shorter.until = 1.206;
      measure_error_by_shorter_steps(run, shorter, error);
      EXPECT_EQ(error.until, 1.2);
      EXPECT_EQ(error.until_later, 1.206);
      EXPECT_FALSE(error.failed_in_other);
    }



    TEST(StepDifference, of_three_runs_tells_first_order)
    {
      const double p      = 1.;
      const auto   at     = [&](const double step) { return 0.01 * std::pow(step / 2e-3, p); };
      StepRecord   middle = run_with(4e-3, at(4e-3)), shorter = run_with(2e-3, at(2e-3));
      Summary::ProbableError error = unknown_error();
      measure_error(run_with(8e-3, at(8e-3)), middle, error);
      measure_error(middle, shorter, error);
      EXPECT_NEAR(error.step.part[0], 0.01, 1e-3);
      EXPECT_NEAR(error.half_step.part[0], 0.005, 1e-3);
    }



    TEST(StepDifference, that_falls_more_slowly_is_the_error_itself)
    {
      StepRecord             middle = run_with(4e-3, 0.024), shorter = run_with(2e-3, 0.01);
      Summary::ProbableError error = unknown_error();
      measure_error(run_with(8e-3, 0.044), middle, error);
      error = unknown_error();
      measure_error(middle, shorter, error);
      EXPECT_NEAR(error.step.part[0], 0.014, 1e-3); // 0.032 with the order of 0.020 and 0.014
      EXPECT_NEAR(error.half_step.part[0], 0.007, 1e-3);
    }



    TEST(StepDifference, that_does_not_fall_is_how_far_runs_scatter)
    {
      StepRecord             middle = run_with(4e-3, 0.01), shorter = run_with(2e-3, 0.04);
      Summary::ProbableError error = unknown_error();
      measure_error(run_with(8e-3, 0.04), middle, error);
      error = unknown_error();
      measure_error(middle, shorter, error);
      EXPECT_NEAR(error.step.part[0], 0.03 / 1.04, 1e-3);
      EXPECT_EQ(error.half_step.part[0], error.step.part[0]);
    }



    TEST(StepDifference, of_what_does_not_move_ends_the_search)
    {
      StepRecord longer = run_with(4e-3, 0.), shorter = run_with(2e-3, 0.);
      for (StepRecord *record : {&longer, &shorter})
        for (StepRecord::Monitor &monitor : record->monitors)
          for (auto &history : monitor.histories)
            history.assign(history.size(), 0.);
      Summary::ProbableError error = unknown_error();
      measure_error(longer, shorter, error);
      EXPECT_NE(error.reason, "");
      EXPECT_FALSE(error.runs_would_do);
    }



    TEST(StepDifference, with_the_record_of_the_same_steps_changes_nothing)
    {
      StepRecord             same  = run_with(4e-3, 0.);
      Summary::ProbableError error = unknown_error();
      measure_error(run_with(4e-3, 0.1), same, error);
      EXPECT_TRUE(error.runs_would_do);
      EXPECT_EQ(error.reason, unknown_error().reason);
    }



    TEST(StepDifference, tells_the_slip_that_is_left_unless_a_joint_failed)
    {
      StepRecord longer = run_with(4e-3, 0.), shorter = run_with(2e-3, 0.);
      longer.slip_left = -0.12, shorter.slip_left = -0.1;
      EXPECT_NEAR(step_difference(longer, shorter).slip_left, 0.2, 1e-9);
      Summary::ProbableError error = unknown_error();
      measure_error(longer, shorter, error);
      EXPECT_NEAR(error.step.slip_left, 0.2 / std::sqrt(3.), 1e-3);
      longer.until = 1.;
      EXPECT_TRUE(std::isnan(step_difference(longer, shorter).slip_left));
      longer.until     = MonitorSummary::unknown;
      longer.slip_left = shorter.slip_left = 1e-6; // beside a peak of 1
      EXPECT_TRUE(std::isnan(step_difference(longer, shorter).slip_left));
    }
  } // namespace
} // namespace hybrid::output
