// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/library_settings.h>

#include <gtest/gtest.h>

namespace hybrid
{
  TEST(LibrarySettings, AProcessorThatOpenBlasDoesNotKnowGetsKernelsThatItCanRun)
  {
    EXPECT_EQ(better_blas_kernels("Prescott", {true, true}), "SkylakeX");
    EXPECT_EQ(better_blas_kernels("Prescott", {true, false}), "Haswell");
  }


  TEST(LibrarySettings, AProcessorWithoutVectorUnitsKeepsItsKernels)
  {
    EXPECT_EQ(better_blas_kernels("Prescott", {false, false}), "");
  }


  TEST(LibrarySettings, WhatOpenBlasHasFoundStays)
  {
    for (const char *known : {"Haswell", "Zen", "SkylakeX", "Cooperlake", "Nehalem"})
      EXPECT_EQ(better_blas_kernels(known, {true, true}), "");
  }
} // namespace hybrid
