// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/card_line.h>
#include <hybrid/output/formatted.h>

namespace hybrid::output
{
  std::string card_line(const char *format, ...)
  {
    va_list arguments;
    va_start(arguments, format);
    const std::string text = formatted_arguments(format, arguments);
    va_end(arguments);
    return text + "\n";
  }
} // namespace hybrid::output
