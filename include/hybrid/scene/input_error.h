// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace hybrid
{
  /**
   * A mistake of the user: one clear sentence with what is wrong, the value
   * found, what is allowed, and (where known) the file and line.
   *
   * main() prints it as "error: <what>" and exits with code 2. Programmer
   * errors are assertions; numerical failures are returned statuses.
   */
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &sentence)
      : std::runtime_error(sentence)
    {}

    /// Prefixes "file:line: " (line <= 0: "file: ").
    InputError(const std::string &file, const int line, const std::string &sentence)
      : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : std::string()) + ": " +
                           sentence)
    {}
  };
} // namespace hybrid
