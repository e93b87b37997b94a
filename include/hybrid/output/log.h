// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace hybrid::output
{
  /**
   * What the program tells its user, on the screen and in log.txt. Every line is flushed, so the
   * file of a killed run is complete. Times are left out of the file: that of equal runs is equal.
   */
  class Log
  {
  public:
    /// Screen only, until open_file().
    /// @param screen_is_terminal whether a progress line may stand there that must be wiped first.
    explicit Log(std::ostream &screen_stream, bool screen_is_terminal = false);

    /// Lines go to @p file_name too from now on; those written before are caught up.
    /// @throws InputError if the file cannot be written.
    void open_file(const std::string &file_name);

    /// Go on with the log of an earlier run after its first @p length bytes. @throws InputError if
    /// the file cannot be written.
    void resume_file(const std::string &file_name, std::uint64_t length);

    /// Bytes in the file so far.
    std::uint64_t file_length();

    /// One or more lines, without the last newline.
    void info(const std::string &text);

    /// The same, with what differs between equal runs on the screen only.
    void info(const std::string &on_screen, const std::string &in_file);

    /// The same with "warning: " before it; warnings are counted.
    void warning(const std::string &text);

    /// From now on lines go to the file only, but for warnings that are not among those @p known:
    /// what the screen has said already.
    void be_quiet(std::vector<std::string> known);

    /// Lines go to the screen again.
    void speak();

    /// All warnings so far.
    const std::vector<std::string> &warnings() const
    {
      return all_warnings;
    }

  private:
    void write_on_screen(const std::string &text);

    void write_in_file(const std::string &text);

    void catch_up(const std::string &file_name);

    std::ostream            &screen;
    const bool               is_terminal;
    std::ofstream            file;
    std::string              before_file; ///< what was said before open_file()
    std::vector<std::string> all_warnings;

    std::optional<std::vector<std::string>> known_warnings; ///< quiet, but for others than these
  };
} // namespace hybrid::output
