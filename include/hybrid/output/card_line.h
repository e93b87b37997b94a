// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid::output
{
  /// A line of the card of a scene: printf into a string, with a line break.
  std::string card_line(const char *format, ...) __attribute__((format(printf, 1, 2)));
} // namespace hybrid::output
