// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hybrid
{
  /**
   * hybrid NAME words...: what is done with runs, in Python.
   *
   * To add one: a line in the table of tool.cc, and src/tools/hybrid_tools/NAME/command.py with
   * main(words), which reads its words with hybrid_tools.arguments and returns the exit code. Help
   * and suggestions for misspelt names and options follow.
   */
  struct Tool
  {
    std::string name, help; ///< help: one line, of hybrid --help
  };

  /// All of them, in the order of hybrid --help.
  const std::vector<Tool> &tools();

  /**
   * Run a tool: tools/tool.py in share/hybrid beside an installed binary, else where it was built
   * from. @return its exit code. @throws InputError if the scripts or Python are missing.
   */
  int run_tool(const std::string &name, const std::vector<std::string> &words);
} // namespace hybrid
