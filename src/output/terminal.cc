// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/terminal.h>

#include <algorithm>
#include <cstdlib>

#include <sys/ioctl.h>
#include <unistd.h>

namespace hybrid::output
{
  bool standard_output_is_terminal()
  {
    return isatty(STDOUT_FILENO) == 1;
  }



  int terminal_width()
  {
    constexpr int narrowest = 20, usual = 80, widest = 10000;
    winsize       size    = {};
    int           columns = 0;
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0)
      columns = size.ws_col;
    if (columns == 0)
      if (const char *text = std::getenv("COLUMNS"))
        columns = std::atoi(text);
    return columns <= 0 ? usual : std::clamp(columns, narrowest, widest);
  }



  std::string
  fitting_line(const std::vector<std::string> &parts, const std::string &gap, const int width)
  {
    std::string line;
    for (const std::string &part : parts)
      {
        const std::string longer = line.empty() ? part : line + gap + part;
        if (longer.size() > static_cast<std::size_t>(width))
          return line.empty() ? part.substr(0, width) : line;
        line = longer;
      }
    return line;
  }
} // namespace hybrid::output
