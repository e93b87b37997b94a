// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/formatted.h>

#include <algorithm>
#include <cstdio>

namespace hybrid::output
{
  std::string formatted(const char *format, ...)
  {
    va_list arguments;
    va_start(arguments, format);
    std::string text = formatted_arguments(format, arguments);
    va_end(arguments);
    return text;
  }



  std::string formatted_arguments(const char *format, va_list arguments)
  {
    va_list again;
    va_copy(again, arguments);
    const int   length = std::max(0, std::vsnprintf(nullptr, 0, format, arguments));
    std::string text(static_cast<std::size_t>(length) + 1, '\0');
    std::vsnprintf(text.data(), text.size(), format, again);
    va_end(again);
    text.pop_back(); // the end of C's string
    return text;
  }
} // namespace hybrid::output
