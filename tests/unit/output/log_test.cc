// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/log.h>
#include <hybrid/scene/input_error.h>

#include <sstream>

#include "python_check.h"

namespace hybrid::output
{
  namespace
  {
    TEST(Log, ScreenAndFileGetTheSameLinesAtOnce)
    {
      const std::string  directory = test::make_directory("log");
      const std::string  name      = directory + "/log.txt";
      std::ostringstream screen;
      Log                log(screen);
      log.info("early");
      log.open_file(name);
      log.warning("mesh too coarse");
      log.info("end");
      EXPECT_EQ(screen.str(), "early\nwarning: mesh too coarse\nend\n");
      EXPECT_EQ(test::read_text(name), screen.str());
      EXPECT_EQ(log.warnings(), std::vector<std::string>{"mesh too coarse"});

      const std::string before = screen.str();
      EXPECT_EQ(log.file_length(), before.size());
      log.info("after the checkpoint");
      Log resumed(screen);
      resumed.resume_file(name, before.size());
      EXPECT_EQ(resumed.file_length(), before.size());
      resumed.info("again");
      EXPECT_EQ(test::read_text(name), before + "again\n");
    }


    TEST(Log, QuietOneTellsTheScreenNewWarningsOnly)
    {
      const std::string  name = test::make_directory("quiet_log") + "/log.txt";
      std::ostringstream screen;
      Log                log(screen);
      log.open_file(name);
      log.be_quiet({"known"});
      log.info("card");
      log.warning("known");
      log.warning("new");
      log.speak();
      log.info("end");
      EXPECT_EQ(screen.str(), "warning: new\nend\n");
      EXPECT_EQ(test::read_text(name), "card\nwarning: known\nwarning: new\nend\n");
      EXPECT_EQ(log.warnings(), (std::vector<std::string>{"known", "new"}));
    }


    TEST(Log, ProgressLineIsWipedOnATerminalOnly)
    {
      std::ostringstream screen;
      Log                log(screen, true);
      log.info("text");
      EXPECT_EQ(screen.str(), "\r\033[Ktext\n");
    }


    TEST(Log, UnwritableFileIsAnInputError)
    {
      std::ostringstream screen;
      EXPECT_THROW(Log(screen).open_file("/no/such/directory/log.txt"), InputError);
    }
  } // namespace
} // namespace hybrid::output
