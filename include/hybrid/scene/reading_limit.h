// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid::scene
{
  /**
   * While it lives, the process may use so much processor time and memory for a file, and not
   * more.
   *
   * A list {1:1e18} or a loop over it keeps gmsh busy for ever, within a call that cannot be
   * stopped: after the time the process ends with a sentence about the file and exit code 2, the
   * code of user errors. Beyond the memory an allocation fails (std::bad_alloc), before the machine
   * begins to end other programs. Only one limit may live at a time.
   */
  class ReadingLimit
  {
  public:
    static constexpr double memory = 2.; ///< beside what the process has already [GB]

    /// @param file that is being read.
    /// @param seconds of processor time; waiting does not count [s].
    explicit ReadingLimit(const std::string &file, double seconds = 30.);

    ~ReadingLimit();

    ReadingLimit(const ReadingLimit &)            = delete;
    ReadingLimit &operator=(const ReadingLimit &) = delete;

    /// What to tell the user of a bad_alloc meanwhile, without the file.
    static std::string memory_sentence();
  };
} // namespace hybrid::scene
