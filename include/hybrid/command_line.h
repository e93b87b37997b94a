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
    version,
    help,
    tool
  };


  /// A parsed command line.
  struct CommandLine
  {
    Action                   action = Action::run;
    std::string              target;        ///< parameter file or run directory
    std::vector<std::string> overrides;     ///< of -s, "Section/Name=value"
    bool                     force = false; ///< replace an earlier run
    std::string              help;          ///< the text, for Action::help
    std::string              tool;          ///< its name, for Action::tool
    std::vector<std::string> words;         ///< what it is given
  };


  /// @throws InputError for anything that is not in the help.
  CommandLine parse_command_line(int argc, const char *const *argv);
} // namespace hybrid
