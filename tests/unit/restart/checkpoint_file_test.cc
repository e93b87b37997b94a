// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/archive.h>
#include <hybrid/restart/checkpoint_file.h>
#include <hybrid/restart/durable_file.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <vector>

namespace hybrid::restart
{
  namespace
  {
    class CheckpointFile : public testing::Test
    {
    protected:
      const std::string directory = testing::TempDir() + "hybrid_checkpoint_file";
      const std::string file      = directory + "/state.bin";
      const std::string state     = std::string("state\0of a run", 14);

      void SetUp() override
      {
        std::filesystem::remove_all(directory);
        std::filesystem::create_directories(directory);
        write_checkpoint(file, 42, [this](Archive &archive) {
          for (char byte : state)
            archive(byte);
        });
      }

      std::string bytes() const
      {
        std::ifstream stream(file, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
      }

      /// What read_checkpoint() says about @p content.
      std::string complaint(const std::string &content) const
      {
        std::ofstream(file, std::ios::binary) << content;
        try
          {
            read_checkpoint(file);
          }
        catch (const InputError &error)
          {
            return error.what();
          }
        return "";
      }
    };



    TEST_F(CheckpointFile, ReadsWhatItWroteAndLeavesNothingElse)
    {
      const CheckpointContent content = read_checkpoint(file);
      EXPECT_EQ(content.layout, 42u);
      EXPECT_EQ(content.state, state);
      EXPECT_FALSE(std::filesystem::exists(temporary_name(file)));
    }



    TEST_F(CheckpointFile, AnotherVersionIsNamed)
    {
      std::string content    = bytes();
      content[12]            = static_cast<char>(checkpoint_version + 1);
      const std::string text = complaint(content);
      EXPECT_NE(text.find("has version " + std::to_string(checkpoint_version + 1) +
                          ", this program reads version " + std::to_string(checkpoint_version)),
                std::string::npos)
        << text;
      EXPECT_NE(text.find(file), std::string::npos) << text;
    }



    TEST_F(CheckpointFile, EveryChangedByteIsRefused)
    {
      const std::string good = bytes();
      // The layout (bytes 16 to 23) is for the caller to compare.
      for (std::size_t k = 0; k < good.size(); ++k)
        if (k < 16 || k >= 24)
          {
            std::string content = good;
            content[k]          = static_cast<char>(content[k] ^ 1);
            EXPECT_NE(complaint(content), "") << k;
          }
    }



    TEST_F(CheckpointFile, EveryShorterFileIsRefused)
    {
      const std::string good = bytes();
      for (std::size_t n = 0; n < good.size(); ++n)
        EXPECT_NE(complaint(good.substr(0, n)), "") << n;
      EXPECT_NE(complaint(good + "x"), "");
      EXPECT_EQ(complaint(good), "");
    }



    TEST_F(CheckpointFile, MissingAndForeignFilesAreNamed)
    {
      EXPECT_NE(complaint("Once upon a time there was a file.").find("is no checkpoint of hybrid"),
                std::string::npos);
      std::remove(file.c_str());
      EXPECT_THROW(read_checkpoint(file), InputError);
    }



    TEST_F(CheckpointFile, AFailedWriteLeavesTheOldOne)
    {
      const std::string good = bytes();
      std::filesystem::create_directories(temporary_name(file) + "/x"); // in the way
      const auto nothing = [](Archive &) {};
      EXPECT_THROW(write_checkpoint(file, 1, nothing), InputError);
      EXPECT_EQ(bytes(), good);
      EXPECT_THROW(write_checkpoint(directory + "/nowhere/state.bin", 1, nothing), InputError);
    }



    TEST_F(CheckpointFile, AStateThatCannotBeWrittenLeavesTheOldOne)
    {
      const std::string good = bytes();
      EXPECT_THROW(write_checkpoint(file, 1, [](Archive &) { throw InputError("no"); }),
                   InputError);
      EXPECT_EQ(bytes(), good);
      EXPECT_FALSE(std::filesystem::exists(temporary_name(file)));
    }



    TEST_F(CheckpointFile, ALargeStateIsWrittenInPortions)
    {
      std::vector<double> values(400000), copy;
      std::iota(values.begin(), values.end(), 0.5);
      write_checkpoint(file, 1, [&](Archive &archive) { archive(values, values); });
      const CheckpointContent content = read_checkpoint(file);
      Archive                 archive = Archive::reader_of(content.state);
      archive(copy, copy);
      EXPECT_EQ(copy, values);
      EXPECT_TRUE(archive.at_end());
    }
  } // namespace
} // namespace hybrid::restart
