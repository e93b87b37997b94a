// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/blas_kernels.h>

#include <cstdlib>

extern "C"
{
  char *openblas_get_corename();

  // What OpenBLAS calls when it is loaded and unloaded, if it has kernels of several processors.
  __attribute__((weak)) void gotoblas_dynamic_init();
  __attribute__((weak)) void gotoblas_dynamic_quit();
}

namespace hybrid
{
  namespace
  {
    VectorUnits vector_units()
    {
#ifdef __x86_64__
      return {__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0,
              __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
                __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512dq") != 0};
#else
      return {};
#endif
    }
  } // namespace



  std::string better_blas_kernels(const std::string &chosen, const VectorUnits &processor)
  {
    if (chosen != "Prescott")
      return "";
    if (processor.avx512)
      return "SkylakeX";
    return processor.avx2 ? "Haswell" : "";
  }



  void use_better_blas_kernels()
  {
    constexpr const char *name = "OPENBLAS_CORETYPE";
    if (std::getenv(name) != nullptr || gotoblas_dynamic_init == nullptr ||
        gotoblas_dynamic_quit == nullptr)
      return;
    const std::string kernels = better_blas_kernels(openblas_get_corename(), vector_units());
    if (kernels.empty() || setenv(name, kernels.c_str(), 0) != 0)
      return;
    gotoblas_dynamic_quit();
    gotoblas_dynamic_init();
  }
} // namespace hybrid
