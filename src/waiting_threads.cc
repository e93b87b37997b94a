// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/waiting_threads.h>

#include <cstdlib>
#include <filesystem>
#include <mpi.h>
#include <unistd.h>

namespace hybrid
{
  void sleep_while_waiting(const int threads, char **argv)
  {
    int has_mpi = 0;
    MPI_Initialized(&has_mpi); // then main() belongs to another program, which goes on
    if (threads <= 1 || has_mpi != 0 || std::getenv("OMP_WAIT_POLICY") != nullptr ||
        std::getenv("GOMP_SPINCOUNT") != nullptr)
      return;
    // Long enough for the gap between two loops of a step; a waiting thread that spins for longer
    // takes the core from another program (doc/performance.md).
    constexpr const char *spins = "1000";
    std::error_code       error;
    const auto            program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error || setenv("OMP_WAIT_POLICY", "passive", 0) != 0 ||
        setenv("GOMP_SPINCOUNT", spins, 0) != 0)
      return;
    execv(program.c_str(), argv);
  }
} // namespace hybrid
