// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/library_settings.h>

#include <cstdlib>
#include <filesystem>
#include <mpi.h>
#include <unistd.h>

extern "C" char *
openblas_get_corename();

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



    /// @return whether the environment has changed.
    bool let_waiting_threads_sleep(const int threads)
    {
      if (threads <= 1 || std::getenv("OMP_WAIT_POLICY") != nullptr ||
          std::getenv("GOMP_SPINCOUNT") != nullptr)
        return false;
      // Long enough for the gap between two loops of a step; a waiting thread that spins for longer
      // takes the core from another program (doc/performance.md).
      constexpr const char *spins = "1000";
      return setenv("OMP_WAIT_POLICY", "passive", 0) == 0 &&
             setenv("GOMP_SPINCOUNT", spins, 0) == 0;
    }



    /// @return whether the environment has changed.
    bool choose_blas_kernels()
    {
      constexpr const char *name = "OPENBLAS_CORETYPE";
      if (std::getenv(name) != nullptr)
        return false;
      const std::string kernels = better_blas_kernels(openblas_get_corename(), vector_units());
      return !kernels.empty() && setenv(name, kernels.c_str(), 0) == 0;
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



  void apply_library_settings(const int threads, char **argv)
  {
    int has_mpi = 0;
    MPI_Initialized(&has_mpi); // then main() belongs to another program, which goes on
    if (has_mpi != 0)
      return;
    std::error_code error;
    const auto      program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error)
      return;
    const bool threads_changed = let_waiting_threads_sleep(threads);
    if (choose_blas_kernels() || threads_changed)
      execv(program.c_str(), argv);
  }
} // namespace hybrid
