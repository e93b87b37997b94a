// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/log.h>
#include <hybrid/scene/input_error.h>

#include <filesystem>

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
    write(text, text);
  }



  void Log::info(const std::string &on_screen, const std::string &in_file)
  {
    write(on_screen, in_file);
  }



  void Log::warning(const std::string &text)
  {
    all_warnings.push_back(text);
    write("warning: " + text, "warning: " + text);
  }



  void Log::write(const std::string &on_screen, const std::string &in_file)
  {
    screen << (is_terminal ? "\r\033[K" : "") << on_screen << std::endl;
    if (file.is_open())
      file << in_file << std::endl;
    else
      before_file += in_file + "\n";
  }
} // namespace hybrid::output
