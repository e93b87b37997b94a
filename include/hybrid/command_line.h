// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hybrid
{
  /// What the user asks for.
  enum class Action
  {
    run,
    check,
    resume,
    print_parameters,
    plot,
    version,
    help
  };


  /// A parsed command line.
  struct CommandLine
  {
    Action                   action = Action::help;
    std::string              target;        ///< parameter file or run directory
    std::vector<std::string> overrides;     ///< of -s, "Section/Name=value"
    bool                     force = false; ///< replace an earlier run
  };


  /// @throws InputError for anything that is not in usage().
  CommandLine parse_command_line(int argc, const char *const *argv);

  /// Text of --help.
  std::string usage();
} // namespace hybrid
