// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <ostream>
#include <string>
#include <vector>

namespace hybrid::output
{
  /**
   * What the program tells its user, on the screen and in log.txt. Every line is flushed, so the
   * file of a killed run is complete. Times are left out: the log of equal runs is equal.
   */
  class Log
  {
  public:
    enum class FileMode
    {
      create, ///< a new file
      append  ///< go on with the log of an earlier run
    };

    /// Screen only, until open_file().
    /// @param screen_is_terminal whether a progress line may stand there that must be wiped first.
    explicit Log(std::ostream &screen_stream, bool screen_is_terminal = false);

    /// Lines go to @p file_name too from now on; those written before are caught up.
    /// @throws InputError if the file cannot be written.
    void open_file(const std::string &file_name, FileMode mode = FileMode::create);

    /// One or more lines, without the last newline.
    void info(const std::string &text);

    /// The same with "warning: " before it; warnings are counted.
    void warning(const std::string &text);

    /// All warnings so far.
    const std::vector<std::string> &warnings() const
    {
      return all_warnings;
    }

  private:
    void write(const std::string &text);

    std::ostream            &screen;
    const bool               is_terminal;
    std::ofstream            file;
    std::string              before_file; ///< what was said before open_file()
    std::vector<std::string> all_warnings;
  };
} // namespace hybrid::output
