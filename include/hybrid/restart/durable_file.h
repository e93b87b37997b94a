// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace hybrid::restart
{
  /// Where the new version of a file is written before it takes the file's name.
  std::string temporary_name(const std::string &file_name);

  /**
   * Write a file under a temporary name and rename it: whoever reads @p file_name finds the old
   * content or the new one, also after a kill at any moment.
   * @param write hands the content to its argument, portion by portion
   * @param durable also after a power failure: waits until the disk has it.
   * @throws WriteError, or what @p write throws; the old content is still there.
   */
  void
  replace_file(const std::string &file_name,
               const std::function<void(const std::function<void(std::string_view)> &file)> &write,
               bool durable);

  /// The same with a content that is in memory.
  void replace_file(const std::string &file_name, std::string_view content, bool durable);

  /// A file that was written under its temporary name takes its name. @param durable as in
  /// replace_file()
  /// @return 0, or the errno of what failed
  int put_in_place(const std::string &file_name, bool durable);
} // namespace hybrid::restart
