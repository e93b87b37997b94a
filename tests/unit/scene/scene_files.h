// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/scene_reader.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace hybrid::scene::test
{
  /// A fresh directory with scene files, removed at the end of the test.
  class SceneFiles : public ::testing::Test
  {
  protected:
    SceneFiles()
      : directory(std::filesystem::temp_directory_path() /
                  ("hybrid_scene_" + std::to_string(getpid()) + "_" +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name()))
    {
      std::filesystem::create_directories(directory);
      write("section.geo", "");
    }

    ~SceneFiles() override
    {
      std::filesystem::remove_all(directory);
    }

    std::string path(const std::string &name) const
    {
      return (directory / name).string();
    }

    std::string write(const std::string &name, const std::string &text) const
    {
      std::filesystem::create_directories((directory / name).parent_path());
      std::ofstream(directory / name) << text;
      return path(name);
    }

    /// A scene with the least that it needs, and @p more lines at its end (they begin at line 19).
    std::string write_scene(const std::string &more = "") const
    {
      return write("scene.prm",
                   "subsection Mesh\n  set File = section.geo\nend\n"
                   "subsection Materials\n  set Names = rock, clay\n"
                   "  subsection rock\n    set Density = 2450\n  end\n"
                   "  subsection clay\n    set Density = 2220\n  end\n"
                   "end\n"
                   "subsection Continuum\n  set Materials = rock\nend\n"
                   "subsection Blocks\n  set Material = clay\nend\n" +
                     more);
    }

    /// The scene is refused with a message that has all the parts.
    void expect_error(const std::string              &file,
                      const std::vector<std::string> &parts,
                      const std::vector<std::string> &overrides = {}) const
    {
      try
        {
          read_scene(file, overrides);
          ADD_FAILURE() << "accepted, but expected '" << parts.front() << "'";
        }
      catch (const InputError &error)
        {
          const std::string text = error.what();
          for (const std::string &part : parts)
            EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
          EXPECT_EQ(text.find('\n'), std::string::npos) << "more than one line: " << text;
        }
    }

    void expect_option_error(const std::string &option, const std::vector<std::string> &parts) const
    {
      std::vector<std::string> all = parts;
      all.push_back("-s option: ");
      expect_error(write_scene(), all, {option});
    }

  private:
    std::filesystem::path directory;
  };
} // namespace hybrid::scene::test
