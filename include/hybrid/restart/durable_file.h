// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hybrid::restart
{
  /// Where the new version of a file is written before it takes the file's name.
  std::string temporary_name(const std::string &file_name);

  /**
   * Write @p parts one after the other under a temporary name and rename it: whoever reads @p
   * file_name finds the old content or the new one, also after a kill at any moment.
   * @param durable also after a power failure: waits until the disk has it.
   * @throws WriteError; the old content is still there.
   */
  void replace_file(const std::string                   &file_name,
                    const std::vector<std::string_view> &parts,
                    bool                                 durable);
} // namespace hybrid::restart
