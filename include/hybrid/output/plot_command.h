// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid::output
{
  /**
   * `hybrid plot DIR`: all pictures of a run as DIR/figures/NAME.png, by the Python script
   * plot_run.py. The script is looked for in ../share/hybrid/plot beside the binary, then where it
   * was built from.
   * @return the exit code of the script: 0 if all pictures were written.
   * @throws InputError if the directory, its run.h5, the script or Python is missing.
   */
  int plot(const std::string &directory);
} // namespace hybrid::output
