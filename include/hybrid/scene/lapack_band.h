// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

extern "C"
{
  // LAPACK: Cholesky factorisation of a symmetric band matrix, and solution with the factor.
  void
  dpbtrf_(const char *uplo, const int *n, const int *kd, double *ab, const int *ldab, int *info);
  void dpbtrs_(const char   *uplo,
               const int    *n,
               const int    *kd,
               const int    *nrhs,
               const double *ab,
               const int    *ldab,
               double       *b,
               const int    *ldb,
               int          *info);
}
