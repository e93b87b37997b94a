// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hybrid::output
{
  /// Whether standard output is a terminal.
  bool standard_output_is_terminal();

  /**
   * Columns of the terminal on standard output: what the terminal itself says now, else the
   * variable COLUMNS, else 80. Never less than 20.
   */
  int terminal_width();

  /**
   * As many @p parts, joined by @p gap, as fit in @p width columns, from the first one on; of a
   * first one that does not fit its beginning. A redrawn line must not reach the last column, where
   * terminals begin another.
   */
  std::string
  fitting_line(const std::vector<std::string> &parts, const std::string &gap, int width);
} // namespace hybrid::output
