// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI
{
  class App; // declared, not included: CLI11
}

namespace hybrid
{
  /**
   * hybrid NAME ...: what is done beside running a scene.
   *
   * To add one: a function in subcommands.cc that declares its words and options with CLI11 and
   * returns what it does, and a line in the table there. Help, suggestions for misspelt words
   * and main() follow. What it is given wrongly it tells by throwing InputError.
   */
  struct Subcommand
  {
    std::string name, help; ///< help: one line
    std::string examples;   ///< lines under its options in hybrid NAME --help

    /// Declares the options. @return what is done once they have been read; it returns the exit
    /// code.
    std::function<std::function<int()>(CLI::App &)> declare;
  };

  /// All of them, in the order of hybrid --help.
  const std::vector<Subcommand> &subcommands();
} // namespace hybrid
