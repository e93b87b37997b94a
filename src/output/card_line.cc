// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/card_line.h>

#include <cstdarg>
#include <cstdio>

namespace hybrid::output
{
  std::string card_line(const char *format, ...)
  {
    char    buffer[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof(buffer), format, arguments);
    va_end(arguments);
    return std::string(buffer) + "\n";
  }
} // namespace hybrid::output
