// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/command_line.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;

  CommandLine parse(std::vector<const char *> words)
  {
    words.insert(words.begin(), "hybrid");
    return parse_command_line(static_cast<int>(words.size()), words.data());
  }



  void expect_refused(const std::vector<const char *> &words, const std::string &part)
  {
    try
      {
        parse(words);
        FAIL() << "accepted";
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      }
  }
} // namespace



TEST(CommandLine, a_file_is_run)
{
  const CommandLine command = parse({"scene.prm"});
  EXPECT_EQ(command.action, Action::run);
  EXPECT_EQ(command.target, "scene.prm");
  EXPECT_TRUE(command.overrides.empty());
}



TEST(CommandLine, options_may_stand_before_or_after_the_file)
{
  for (const CommandLine &command :
       {parse({"--check", "scene.prm", "-s", "A/B=1", "-s", "C = d e"}),
        parse({"-s", "A/B=1", "scene.prm", "-s", "C = d e", "--check"})})
    {
      EXPECT_EQ(command.action, Action::check);
      EXPECT_EQ(command.target, "scene.prm");
      EXPECT_EQ(command.overrides, (std::vector<std::string>{"A/B=1", "C = d e"}));
    }
}



TEST(CommandLine, other_actions)
{
  EXPECT_EQ(parse({}).action, Action::help);
  EXPECT_EQ(parse({"--help"}).action, Action::help);
  EXPECT_EQ(parse({"scene.prm", "-h"}).action, Action::help);
  EXPECT_EQ(parse({"help"}).action, Action::help);
  EXPECT_EQ(parse({"--version"}).action, Action::version);
  EXPECT_EQ(parse({"version"}).action, Action::version);
  EXPECT_EQ(parse({"--print-parameters"}).action, Action::print_parameters);
  const CommandLine resume = parse({"--resume", "output/run", "-s", "Time/End time=3"});
  EXPECT_EQ(resume.action, Action::resume);
  EXPECT_EQ(resume.target, "output/run");
  EXPECT_EQ(resume.overrides.size(), 1u);
  EXPECT_TRUE(parse({"scene.prm", "--force"}).force);
  EXPECT_FALSE(parse({"scene.prm"}).force);
}



TEST(CommandLine, a_tool_gets_its_words)
{
  const CommandLine plot = parse({"plot", "output", "--help"});
  ASSERT_EQ(plot.action, Action::tool);
  EXPECT_EQ(plot.tool, "plot");
  EXPECT_EQ(plot.words, (std::vector<std::string>{"output", "--help"}));
  EXPECT_EQ(parse({"help", "plot"}).words, std::vector<std::string>{"--help"});
  EXPECT_EQ(parse({"plot", "plot"}).action, Action::tool);
  EXPECT_EQ(parse({"./plot"}).action, Action::run);
}



TEST(CommandLine, mistakes_are_named)
{
  expect_refused({"--fast", "scene.prm"}, "--fast");
  expect_refused({"-s"}, "-s needs");
  expect_refused({"scene.prm", "-s", "Time/Time step"}, "Time/Time step");
  expect_refused({"scene.prm", "-s", "--check"}, "not '--check'");
  expect_refused({"scene.prm", "-s=Time/Time step=1"}, "not '=Time/Time step=1'");
  expect_refused({"--check"}, "no parameter file");
  expect_refused({"--check=yes", "scene.prm"}, "'--check' takes no value");
  expect_refused({"one.prm", "two.prm"}, "two.prm");
  expect_refused({"check", "scene.prm"}, "did you mean '--check'?");
  expect_refused({"check"}, "did you mean '--check'?");
  expect_refused({"--chek", "scene.prm"}, "unknown option '--chek' (did you mean '--check'?)");
  expect_refused({"-check", "scene.prm"}, "unknown option '-check' (did you mean '--check'?)");
  expect_refused({"--versoin"}, "did you mean '--version'?");
  expect_refused({"chek", "scene.prm"}, "'chek' is no action; did you mean '--check'?");
  expect_refused({"--check", "--resume", "output"}, "'--resume' cannot be combined");
  for (const char *word : {"-", "--", "-5"})
    {
      expect_refused({word}, std::string("unknown option '") + word + "'");
      expect_refused({"scene.prm", word}, std::string("unknown option '") + word + "'");
    }
}



TEST(CommandLine, mistakes_with_the_names_of_tools_are_named)
{
  expect_refused({"plott", "output"}, "did you mean 'plot'?");
  expect_refused({"scene.prm", "plot"}, "'plot' stands first");
  expect_refused({"--force", "plot", "output"}, "'plot' stands first");
}



TEST(CommandLine, the_help_lists_every_action)
{
  const std::string help = parse({"--help"}).help;
  for (const char *word : {"PARAMS.prm",
                           "--check",
                           "--resume",
                           "--force",
                           "--print-parameters",
                           "--version",
                           "plot",
                           "-s",
                           "Examples:",
                           "Exit code"})
    EXPECT_NE(help.find(word), std::string::npos) << word;
}
