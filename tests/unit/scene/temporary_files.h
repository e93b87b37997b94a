// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace hybrid::scene::test
{
  /// A fresh directory for small input files, removed at the end of the test.
  class TemporaryFiles : public ::testing::Test
  {
  protected:
    TemporaryFiles()
      : directory(std::filesystem::temp_directory_path() /
                  ("hybrid_files_" + std::to_string(getpid()) + "_" +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name()))
    {
      std::filesystem::create_directories(directory);
    }

    ~TemporaryFiles() override
    {
      std::filesystem::remove_all(directory);
    }

    std::string write(const std::string &name, const std::string &text) const
    {
      std::ofstream(directory / name) << text;
      return (directory / name).string();
    }

    const std::filesystem::path directory;
  };


  /// The message of the InputError that @p action throws; a failure and "" if it throws none.
  template <typename Action>
  std::string message_of(const Action &action)
  {
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    ADD_FAILURE() << "no InputError";
    return "";
  }


  /// Expect that @p message has the text @p part.
  inline void expect_part(const std::string &message, const std::string &part)
  {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
  }
} // namespace hybrid::scene::test
