// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid::scene
{
  /**
   * Why a path as a user wrote it leads nowhere, and what to write instead: quotation marks, a '~'
   * or a variable that only shells replace. Begins with "; "; empty if nothing of that is there.
   */
  std::string path_hint(const std::string &written);


  /// path_hint(), or else that @p path is a directory, or the name next to it among the files of
  /// its directory.
  std::string file_hint(const std::string &written, const std::string &path);
} // namespace hybrid::scene
