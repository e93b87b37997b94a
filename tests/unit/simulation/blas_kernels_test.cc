// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/blas_kernels.h>

#include <gtest/gtest.h>

#include <vector>

extern "C" void
dgemm_(const char   *transpose_a,
       const char   *transpose_b,
       const int    *m,
       const int    *n,
       const int    *k,
       const double *alpha,
       const double *a,
       const int    *lda,
       const double *b,
       const int    *ldb,
       const double *beta,
       double       *c,
       const int    *ldc);

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


  TEST(BlasKernels, ProductsAreRightOnceTheyAreChosen)
  {
    use_better_blas_kernels();
    constexpr int       n = 50; // whole numbers: exact with any kernel
    std::vector<double> a(n * n), b(n * n), c(n * n, -1.);
    for (int k = 0; k < n * n; ++k)
      {
        a[k] = k % 7 - 3;
        b[k] = k % 5 - 2;
      }
    const double one = 1., zero = 0.;
    dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, c.data(), &n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        {
          double sum = 0.;
          for (int k = 0; k < n; ++k)
            sum += a[i + n * k] * b[k + n * j];
          ASSERT_EQ(c[i + n * j], sum) << i << " " << j;
        }
  }
} // namespace hybrid
