// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/mesh_difference.h>

#include "shaken_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    TEST(MeshError, of_three_meshes_of_second_order)
    {
      Summary::MeshError error;
      measure_mesh_error(run_with(2e-3, 0.01),
                         {run_with(2e-3, 0.04), run_with(2e-3, 0.16)},
                         2.,
                         error);
      EXPECT_EQ(error.reason, "");
      EXPECT_EQ(error.meshes, 2);
      EXPECT_NEAR(error.size.part[0], 0.01, 1e-3);
      EXPECT_NEAR(error.half_size.part[0], 0.0025, 3e-4);
    }



    TEST(MeshError, of_waves_alone_may_be_of_third_order)
    {
      Summary::MeshError error;
      measure_mesh_error(run_with(2e-3, 0.01),
                         {run_with(2e-3, 0.08), run_with(2e-3, 0.64)},
                         3.,
                         error);
      EXPECT_NEAR(error.size.part[0], 0.01, 1e-3);
      EXPECT_NEAR(error.half_size.part[0], 0.00125, 2e-4);
    }



    TEST(MeshError, of_one_coarser_mesh_is_between_first_and_second_order)
    {
      Summary::MeshError error;
      measure_mesh_error(run_with(2e-3, 0.02), {run_with(2e-3, 0.04)}, 2., error);
      EXPECT_NEAR(error.size.part[0], 0.02 / std::sqrt(3.), 5e-4);
      EXPECT_NEAR(error.half_size.part[0], 0.02 / std::sqrt(3.) / (1. + std::sqrt(3.)), 3e-4);
    }



    TEST(MeshError, that_is_close_by_luck_counts_as_the_coarser_two_say)
    {
      Summary::MeshError error;
      measure_mesh_error(run_with(2e-3, 0.0101),
                         {run_with(2e-3, 0.01), run_with(2e-3, 0.09)},
                         2.,
                         error);
      EXPECT_NEAR(error.size.part[0], 0.08 / 4. / 3., 1e-3);
    }



    TEST(MeshError, without_an_order_leaves_as_much_with_half_the_size)
    {
      Summary::MeshError error;
      measure_mesh_error(run_with(2e-3, 0.02),
                         {run_with(2e-3, 0.05), run_with(2e-3, 0.02)},
                         2.,
                         error);
      EXPECT_NEAR(error.size.part[0], 0.03 / std::sqrt(3.), 1e-3);
      EXPECT_EQ(error.half_size.part[0], error.size.part[0]);
    }
  } // namespace
} // namespace hybrid::output
