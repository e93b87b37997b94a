// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * While it lives, a crash of the process (segmentation fault, abort, an
   * exception that leaves a library's thread) ends it with a sentence about a
   * file and exit code 2, the code of user errors.
   *
   * gmsh 4.8 throws strings out of its OpenMP regions for curve loops that do not
   * close, and reads past the end of malformed element lines; neither can be
   * caught. Only one guard may live at a time.
   */
  class CrashGuard
  {
  public:
    /// @param file that is being read.
    explicit CrashGuard(const std::string &file);

    ~CrashGuard();

    /// Files, and then directories if they are empty, that a crash within any guard deletes,
    /// instead of those given before.
    static void delete_at_crash(std::vector<std::string> paths);

    /// From now on a crash ends a run whose results are complete: with these words, after the
    /// file's name, and exit code 0. Empty: it is an error again.
    static void spoils_nothing(std::string words);

    /// Name what the crash will be due to, in place of a list of what it may be due to.
    /// @param what "bedding_1 lies within surface 1: divide the surface along it".
    void suspect(const std::string &what);

    CrashGuard(const CrashGuard &)            = delete;
    CrashGuard &operator=(const CrashGuard &) = delete;

  private:
    const std::string file;
  };
} // namespace hybrid::scene
