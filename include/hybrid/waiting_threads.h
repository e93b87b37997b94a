// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid
{
  /**
   * Let threads that wait for work sleep. By default those of libgomp spin, and on a machine with
   * other work they take the processors from the threads that they wait for.
   *
   * libgomp reads how to wait from the environment when it is loaded, so this starts the program
   * anew, with OMP_WAIT_POLICY=passive. It returns with one thread, with OMP_WAIT_POLICY or
   * GOMP_SPINCOUNT in the environment, after MPI_Init(), or if the program cannot be started anew.
   *
   * @param argv the arguments of main(), unchanged
   */
  void sleep_while_waiting(int threads, char **argv);
} // namespace hybrid
