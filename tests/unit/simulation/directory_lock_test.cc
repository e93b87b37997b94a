// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/directory_lock.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include <filesystem>

using namespace hybrid;

TEST(DirectoryLock, a_directory_is_that_of_one_run_while_this_lives)
{
  const std::string directory = testing::TempDir() + "hybrid_directory_lock";
  std::filesystem::create_directories(directory);
  {
    DirectoryLock first, second;
    first.take(directory);
    first.take(directory); // it has it
    try
      {
        second.take(directory);
        FAIL();
      }
    catch (const InputError &error)
      {
        const std::string text = error.what();
        EXPECT_NE(text.find("'" + directory + "'"), std::string::npos) << text;
        EXPECT_NE(text.find("another run"), std::string::npos) << text;
      }
  }
  DirectoryLock next;
  next.take(directory);
  EXPECT_TRUE(std::filesystem::is_empty(directory));
}
