// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/log.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace hybrid::output
{
  Log::Log(std::ostream &screen_stream, const bool screen_is_terminal)
    : screen(screen_stream)
    , is_terminal(screen_is_terminal)
  {}



  void Log::open_file(const std::string &file_name)
  {
    file.open(file_name, std::ios::trunc);
    catch_up(file_name);
  }



  void Log::resume_file(const std::string &file_name, const std::uint64_t length)
  {
    std::error_code error;
    if (std::filesystem::file_size(file_name, error) > length && !error)
      std::filesystem::resize_file(file_name, length, error);
    file.open(file_name, std::ios::app);
    catch_up(file_name);
  }



  std::uint64_t Log::file_length()
  {
    return file.is_open() ? static_cast<std::uint64_t>(file.tellp()) : 0;
  }



  void Log::catch_up(const std::string &file_name)
  {
    file << before_file << std::flush;
    if (!file)
      throw InputError("cannot write '" + file_name +
                       "': the directory must exist and be writable.");
    before_file.clear();
  }



  void Log::info(const std::string &text)
  {
    info(text, text);
  }



  void Log::info(const std::string &on_screen, const std::string &in_file)
  {
    if (!known_warnings)
      write_on_screen(on_screen);
    write_in_file(in_file);
  }



  void Log::warning(const std::string &text)
  {
    const bool is_known =
      known_warnings &&
      std::find(known_warnings->begin(), known_warnings->end(), text) != known_warnings->end();
    all_warnings.push_back(text);
    if (!is_known)
      write_on_screen("warning: " + text);
    write_in_file("warning: " + text);
  }



  void Log::be_quiet(std::vector<std::string> known)
  {
    known_warnings = std::move(known);
  }



  void Log::speak()
  {
    known_warnings.reset();
  }



  void Log::write_on_screen(const std::string &text)
  {
    screen << (is_terminal ? "\r\033[K" : "") << text << std::endl;
  }



  void Log::write_in_file(const std::string &text)
  {
    if (file.is_open())
      file << text << std::endl;
    else
      before_file += text + "\n";
  }
} // namespace hybrid::output
