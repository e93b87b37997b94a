// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid
{
  /// What the processor computes with.
  struct VectorUnits
  {
    bool avx2   = false; ///< with fused multiplication and addition
    bool avx512 = false; ///< with byte, word and double word operations on vectors of any length
  };


  /**
   * The kernels that OpenBLAS should use, as it names them; empty: those it has chosen. It gives a
   * processor that is newer than itself those of 2004 (Prescott), a sixth as fast with products.
   */
  std::string better_blas_kernels(const std::string &chosen, const VectorUnits &processor);


  /**
   * What libraries read from the environment when they are loaded. Where something is missing it
   * is set, and the program started anew:
   * - threads that wait for work shall sleep (OMP_WAIT_POLICY=passive). By default those of libgomp
   *   spin, and on a machine with other work they take the processors from the threads that they
   *   wait for;
   * - better_blas_kernels() (OPENBLAS_CORETYPE).
   *
   * What the environment has stays. It returns without any change after MPI_Init(), and if the
   * program cannot be started anew.
   *
   * @param threads that the program will use
   * @param argv the arguments of main(), unchanged
   */
  void apply_library_settings(int threads, char **argv);
} // namespace hybrid
