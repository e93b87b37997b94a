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


  /// Let OpenBLAS use better_blas_kernels(), unless OPENBLAS_CORETYPE is in the environment. Before
  /// anything is computed with it.
  void use_better_blas_kernels();
} // namespace hybrid
