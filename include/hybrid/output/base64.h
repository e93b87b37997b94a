// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace hybrid::output
{
  /// Add bytes to a text in base64: four characters for three bytes, the last ones filled up with
  /// =.
  void append_base64(std::string &text, const void *data, std::size_t n_bytes);
} // namespace hybrid::output
