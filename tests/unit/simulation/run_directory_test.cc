// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/run_directory.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
  using namespace hybrid;
  namespace fs = std::filesystem;

  class RunDirectory : public testing::Test
  {
  protected:
    scene::SceneParameters scene;
    std::ostringstream     screen;
    output::Log            log{screen};
    DirectoryLock          lock;
    std::string            directory = testing::TempDir() + "hybrid_run_directory";

    void SetUp() override
    {
      fs::remove_all(directory);
      scene.output.directory = directory;
      scene.used_prm         = "set Title = a run\n";
    }

    void touch(const std::string &name) const
    {
      fs::create_directories(fs::path(directory + "/" + name).parent_path());
      std::ofstream(directory + "/" + name) << "content";
    }
  };
} // namespace



TEST_F(RunDirectory, an_earlier_run_is_kept_unless_forced)
{
  prepare_directory(scene, false, log, lock);
  EXPECT_TRUE(fs::exists(directory + "/params.used.prm"));
  const auto of_run  = {"summary.json",
                        "run.h5",
                        "run.h5.tmp",
                        "summary.json.tmp",
                        "vtu/blocks_00001.vtu",
                        "vtu/joints_00002.vtu.tmp",
                        "checkpoint/state.bin"};
  const auto of_user = {"vtu/mine.vtu", "notes.txt", "figures/overview.png"};
  for (const auto &names : {of_run, of_user})
    for (const char *name : names)
      touch(name);
  try
    {
      prepare_directory(scene, false, log, lock);
      FAIL();
    }
  catch (const InputError &error)
    {
      const std::string text = error.what();
      for (const std::string &part : {directory, std::string("--resume"), std::string("--force")})
        EXPECT_NE(text.find(part), std::string::npos) << text;
    }
  EXPECT_TRUE(fs::exists(directory + "/run.h5"));

  output::Log second(screen);
  prepare_directory(scene, true, second, lock);
  for (const char *name : of_run)
    EXPECT_FALSE(fs::exists(directory + "/" + name)) << name;
  for (const char *name : of_user)
    EXPECT_TRUE(fs::exists(directory + "/" + name)) << name;
}



TEST_F(RunDirectory, a_run_killed_before_its_parameters_were_written_is_not_offered_for_resume)
{
  touch("log.txt");
  try
    {
      refuse_earlier_run(directory);
      FAIL();
    }
  catch (const InputError &error)
    {
      const std::string text = error.what();
      EXPECT_EQ(text.find("--resume"), std::string::npos) << text;
      for (const std::string &part : {directory, std::string("--force")})
        EXPECT_NE(text.find(part), std::string::npos) << text;
    }
}



TEST(ResumeCommand, quotes_what_a_shell_would_split)
{
  EXPECT_EQ(resume_command("output/run_1"), "hybrid --resume output/run_1");
  EXPECT_EQ(resume_command("my results"), "hybrid --resume \"my results\"");
}



TEST_F(RunDirectory, a_run_killed_while_its_scene_was_prepared_can_be_resumed_or_repeated)
{
  scene.output.directory += "/in/another";
  {
    ScenePrepared preparation;
    preparation.begin(scene, lock);
    EXPECT_TRUE(fs::exists(scene.output.directory + "/params.used.prm"));
    EXPECT_TRUE(has_not_begun(scene.output.directory));
    EXPECT_NO_THROW(refuse_earlier_run(scene.output.directory));
    prepare_directory(scene, false, log, lock);
    preparation.done();
  }
  EXPECT_TRUE(fs::exists(scene.output.directory + "/params.used.prm"));
  touch("in/another/run.h5");
  fs::remove(scene.output.directory + "/params.used.prm");
  ScenePrepared().begin(scene, lock);
  EXPECT_FALSE(fs::exists(scene.output.directory + "/params.used.prm")) << "of an earlier run";
}



TEST_F(RunDirectory, a_scene_that_is_refused_leaves_nothing)
{
  scene.output.directory += "/in/another";
  ScenePrepared().begin(scene, lock);
  EXPECT_FALSE(fs::exists(directory));
  DirectoryLock of_next;
  touch("in/mine.txt");
  ScenePrepared().begin(scene, of_next);
  EXPECT_FALSE(fs::exists(scene.output.directory));
  EXPECT_TRUE(fs::exists(directory + "/in/mine.txt"));
}



TEST_F(RunDirectory, a_directory_with_other_files_can_be_used)
{
  touch("notes.txt");
  prepare_directory(scene, false, log, lock);
  EXPECT_TRUE(fs::exists(directory + "/notes.txt"));
}



TEST_F(RunDirectory, nothing_to_resume_is_said)
{
  EXPECT_THROW(read_scene_of_run(directory, {}), InputError);
}



TEST_F(RunDirectory, a_run_without_steps_has_not_begun)
{
  prepare_directory(scene, false, log, lock);
  EXPECT_TRUE(has_not_begun(directory));
  touch("summary.json");
  EXPECT_FALSE(has_not_begun(directory));
  fs::remove(directory + "/summary.json");
  touch("checkpoint/state.bin");
  EXPECT_FALSE(has_not_begun(directory));
}
