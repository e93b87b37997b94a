// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/mesh_difference.h>

#include "shaken_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr double     step   = 2e-3;
    constexpr MeshOrders blocks = {1., 2., 1., 0.5}, waves = {2., 8., 2., 0.25},
                         smooth_waves = {2., 4., 4., 0.5};



    /// Of a run that has the first of these errors, those of coarser meshes have the others.
    Summary::MeshError error_of(const std::vector<double> &errors, const MeshOrders orders)
    {
      std::vector<StepRecord> coarser;
      for (std::size_t i = 1; i < errors.size(); ++i)
        coarser.push_back(run_with(step, errors[i]));
      Summary::MeshError error;
      measure_mesh_error(run_with(step, errors[0]), coarser, orders, error);
      return error;
    }



    /// A part of the displacements of the point on top, slow enough for its velocity not to tell.
    StepRecord displaced(StepRecord record, const double part)
    {
      auto &history = record.monitors[0].histories[0];
      for (std::size_t i = 0; i < record.time.size(); ++i)
        history[2 * i] += part * std::sin(2. * M_PI * record.time[i]);
      return record;
    }



    TEST(MeshDifference, of_three_meshes_tells_their_order)
    {
      for (const double p : {1., 1.5, 2.})
        {
          const double             coarser = std::exp2(p);
          const Summary::MeshError error =
            error_of({0.01, 0.01 * coarser, 0.01 * coarser * coarser}, {0.5, 2., 1., 0.5});
          EXPECT_EQ(error.reason, "");
          EXPECT_EQ(error.meshes, 2);
          EXPECT_TRUE(error.order_is_seen);
          for (int q = 0; q < 3; ++q)
            {
              EXPECT_NEAR(error.size.part[q], 0.01, 3e-4);
              EXPECT_NEAR(error.half_size.part[q], 0.01 / coarser, 3e-4);
            }
        }
    }



    TEST(MeshDifference, of_waves_alone_may_be_of_a_high_order)
    {
      const Summary::MeshError error = error_of({0.001, 0.016, 0.256}, waves);
      EXPECT_NEAR(error.size.part[0], 0.001, 1e-4);
      EXPECT_NEAR(error.half_size.part[0], 0.001 / 16., 1e-5);
    }



    TEST(MeshDifference, to_one_coarser_mesh_counts_with_the_lowest_order)
    {
      const Summary::MeshError error = error_of({0.02, 0.04}, blocks);
      EXPECT_EQ(error.meshes, 1);
      EXPECT_FALSE(error.order_is_seen);
      EXPECT_NEAR(error.size.part[0], 0.02, 5e-4);
      EXPECT_NEAR(error.half_size.part[0], 0.01, 3e-4);
    }



    TEST(MeshDifference, that_falls_too_slowly_is_of_meshes_that_do_not_resolve_the_waves)
    {
      for (const double farthest : {0.9, 0.5, 0.2}) // errors without an order
        {
          const Summary::MeshError error = error_of({0.02, 0.5, farthest}, waves);
          EXPECT_FALSE(error.order_is_seen);
          EXPECT_NEAR(error.size.part[0], 0.48 / 3., 4e-3);
          EXPECT_EQ(error.half_size.part[0], error.size.part[0] / 4.);
        }
    }



    TEST(MeshDifference, without_an_order_counts_with_that_of_dispersion_in_level_layers)
    {
      for (const std::vector<double> &errors : {std::vector<double>{0.02, 0.5, 0.9}, {0.02, 0.5}})
        {
          const Summary::MeshError error = error_of(errors, smooth_waves);
          EXPECT_FALSE(error.order_is_seen);
          EXPECT_NEAR(error.size.part[0], 0.48 / 15., 1e-3);
          EXPECT_EQ(error.half_size.part[0], error.size.part[0] / 16.);
        }
    }



    TEST(MeshDifference, of_displacements_that_are_close_by_luck_has_the_order_of_velocities)
    {
      const StepRecord run = run_with(step, 0.01), coarse = run_with(step, 0.02),
                       coarsest = run_with(step, 0.05);
      Summary::MeshError error;
      measure_mesh_error(displaced(run, 0.0098), {coarse, coarsest}, blocks, error);
      EXPECT_NEAR(error.size.part[1], 0.01 / 2., 2e-4);
      EXPECT_NEAR(error.size.part[0], 0.03 / 12., 1e-4); // the coarser two: at least
      EXPECT_TRUE(error.order_is_seen);
      EXPECT_NEAR(error.half_size.part[1], 0.01 / 2. / 3., 1e-4);
      EXPECT_NEAR(error.half_size.part[0], error.size.part[0] / 3., 1e-4);
    }



    TEST(MeshDifference, that_vanishes_by_luck_is_at_least_what_the_coarser_two_say)
    {
      const Summary::MeshError error = error_of({0.0101, 0.01, 0.09}, blocks);
      EXPECT_NEAR(error.size.part[0], 0.08 / 4. / 3., 1e-3);
    }



    TEST(MeshDifference, ends_where_a_joint_fails_in_a_coarser_mesh)
    {
      StepRecord coarse = run_with(step, 0.02);
      coarse.until      = 1.;
      Summary::MeshError error;
      measure_mesh_error(run_with(step, 0.01), {coarse}, blocks, error);
      EXPECT_EQ(error.until, 1.);
      EXPECT_TRUE(error.failed_in_other);
      StepRecord own = run_with(step, 0.01);
      own.until      = 0.8;
      measure_mesh_error(own, {coarse}, blocks, error);
      EXPECT_EQ(error.until, 0.8);
      EXPECT_FALSE(error.failed_in_other);
      measure_mesh_error(run_with(step, 0.01), {run_with(step, 0.02)}, blocks, error);
      EXPECT_TRUE(std::isnan(error.until));
      EXPECT_FALSE(error.failed_in_other);
    }



    TEST(MeshDifference, of_slip_has_the_order_of_the_motion)
    {
      StepRecord run = run_with(step, 0.01), coarse = run_with(step, 0.02),
                 coarsest = run_with(step, 0.04);
      run.slip_left = 0.100, coarse.slip_left = 0.102, coarsest.slip_left = 0.110;
      Summary::MeshError error;
      measure_mesh_error(run, {coarse, coarsest}, blocks, error);
      EXPECT_NEAR(error.size.slip_left, 0.02, 1e-3);
      EXPECT_NEAR(error.half_size.slip_left, 0.01, 1e-3);
      coarsest.until = 1.; // a joint fails there: no slip of its own to compare
      measure_mesh_error(run, {coarse, coarsest}, blocks, error);
      EXPECT_NEAR(error.size.slip_left, 0.02, 1e-3);
    }



    TEST(MeshDifference, tells_nothing_of_what_cells_leave_that_stay_as_they_are)
    {
      EXPECT_DOUBLE_EQ(coarsened_part(0.25, waves), 1.);
      EXPECT_DOUBLE_EQ(coarsened_part(0.2, waves), 1.); // chance
      EXPECT_DOUBLE_EQ(coarsened_part(0.625, waves), 0.5);
      EXPECT_DOUBLE_EQ(coarsened_part(0.5, smooth_waves), 1.); // one column of cells
      EXPECT_DOUBLE_EQ(coarsened_part(0.5, blocks), 1.);
      // half of the cells stay, with half of the error of 2 % each: 1 % + 4 * 1 % in the coarser
      // one
      Summary::MeshError error;
      error.coarsened = coarsened_part(0.625, waves);
      measure_mesh_error(run_with(step, 0.02), {run_with(step, 0.05)}, waves, error);
      EXPECT_NEAR(error.size.part[0], 0.02, 5e-4);
      EXPECT_NEAR(error.half_size.part[0], 0.005, 2e-4);
    }



    TEST(MeshDifference, of_corners_is_that_to_a_run_with_smaller_cells_there)
    {
      const double       run = 0.02, crack = run / std::sqrt(8.); // of the same corner, eight times
      Summary::MeshError error = error_of({run, run * 1.1, 1.5}, waves);
      EXPECT_LT(error.size.part[0], run / 3.);
      add_corner_error(run_with(step, run), run_with(step, crack), error);
      EXPECT_TRUE(error.of_corners);
      for (int q = 0; q < 3; ++q)
        {
          EXPECT_NEAR(error.size.part[q], run, 1e-3);
          EXPECT_NEAR(error.half_size.part[q], run / std::sqrt(2.), 1e-3);
        }
      Summary::MeshError of_waves = error_of({run, 4. * run, 16. * run}, waves);
      add_corner_error(run_with(step, run), run_with(step, 0.99 * run), of_waves);
      EXPECT_NEAR(of_waves.size.part[0], run, 1e-3); // the larger of the two
      EXPECT_NEAR(of_waves.half_size.part[0], run / 4., 1e-3);
    }
  } // namespace
} // namespace hybrid::output
