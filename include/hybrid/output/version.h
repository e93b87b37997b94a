// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid::output
{
  /**
   * What hybrid --version prints: version and commit of the program, compiler, and the versions of
   * the libraries that results depend on; of those that can tell, the version that is loaded.
   */
  std::string version_text();
} // namespace hybrid::output
