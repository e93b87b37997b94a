// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdarg>
#include <string>

namespace hybrid::output
{
  /// printf into a string, however long.
  std::string formatted(const char *format, ...) __attribute__((format(printf, 1, 2)));

  /// The same with the arguments of another function.
  std::string formatted_arguments(const char *format, va_list arguments)
    __attribute__((format(printf, 1, 0)));
} // namespace hybrid::output
