// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/blas_kernels.h>

#include <gtest/gtest.h>

extern "C" char *
openblas_get_corename();

namespace hybrid
{
  TEST(BlasKernels, AProcessorThatOpenBlasDoesNotKnowGetsKernelsThatItCanRun)
  {
    EXPECT_EQ(better_blas_kernels("Prescott", {true, true}), "SkylakeX");
    EXPECT_EQ(better_blas_kernels("Prescott", {true, false}), "Haswell");
  }


  TEST(BlasKernels, AProcessorWithoutVectorUnitsKeepsItsKernels)
  {
    EXPECT_EQ(better_blas_kernels("Prescott", {false, false}), "");
  }


  TEST(BlasKernels, WhatOpenBlasHasFoundStays)
  {
    for (const char *known : {"Haswell", "Zen", "SkylakeX", "Cooperlake", "Nehalem"})
      EXPECT_EQ(better_blas_kernels(known, {true, true}), "");
  }


  TEST(BlasKernels, NothingBetterIsLeftOnceTheyAreChosen)
  {
    use_better_blas_kernels();
    const std::string used = openblas_get_corename();
    use_better_blas_kernels();
    EXPECT_EQ(openblas_get_corename(), used);
  }
} // namespace hybrid
