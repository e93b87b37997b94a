// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

namespace hybrid::output::test
{
  /// An empty directory of this process, for one test.
  inline std::string make_directory(const std::string &name)
  {
    const auto path = std::filesystem::temp_directory_path() /
                      ("hybrid_output_" + name + "_" + std::to_string(getpid()));
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
    return path.string();
  }


  inline std::string read_text(const std::string &file_name)
  {
    std::ifstream      file(file_name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }


  /// Run a Python script in @p directory; it passes if it ends without an exception.
  inline bool python_passes(const std::string &directory, const std::string &script)
  {
    std::ofstream(directory + "/check.py") << script;
    const std::string command = "cd '" + directory + "' && '" HYBRID_PYTHON "' check.py";
    return std::system(command.c_str()) == 0;
  }
} // namespace hybrid::output::test
