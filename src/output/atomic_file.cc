// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/atomic_file.h>
#include <hybrid/restart/durable_file.h>

namespace hybrid::output
{
  void write_atomically(const std::string &file_name, const std::string &content)
  {
    restart::replace_file(file_name, content, false);
  }
} // namespace hybrid::output
