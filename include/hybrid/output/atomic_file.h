// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid::output
{
  /**
   * Write @p content to a temporary file beside @p file_name, then rename it: whoever reads
   * @p file_name finds the old content or the new one, never a part of it.
   * @throws WriteError if the file cannot be written (missing directory, full disk).
   */
  void write_atomically(const std::string &file_name, const std::string &content);
} // namespace hybrid::output
