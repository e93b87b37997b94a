// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/scene_reader.h>

#include "scene_files.h"

namespace hybrid::scene::test
{
  namespace
  {
    class MotionParametersTest : public SceneFiles
    {};
  } // namespace


  TEST_F(MotionParametersTest, ARecordMayHaveAVerticalComponent)
  {
    write("up.txt", "0 0\n1 1\n2 0\n");
    write("along.txt", "0 0\n1 1\n2 0\n");
    const std::string file =
      write_scene("subsection Motion\n  set Type = text\n  set File = along.txt\n"
                  "  set Vertical file = up.txt\nend\n");
    const MotionParameters motion = read_scene(file).motion;
    EXPECT_EQ(motion.vertical_file, path("up.txt"));
    EXPECT_LT(motion.vertical_peak, 0.);
    EXPECT_DOUBLE_EQ(read_scene(file, {"Motion/Vertical peak=0.1 g"}).motion.vertical_peak,
                     0.980665);
    expect_error(file, {"Motion/Vertical file", "a second component"}, {"Motion/Angle=-90"});
    expect_error(file,
                 {"Motion/Vertical file", "is not used unless Motion/Type"},
                 {"Motion/Type=sine"});
    expect_error(file,
                 {"Motion/Vertical peak", "is not used without Motion/Vertical file"},
                 {"Motion/Vertical file=", "Motion/Vertical peak=1"});
  }


  // As tools do that ask for something else than the scene's motion.
  TEST_F(MotionParametersTest, AMotionThatIsSwitchedOffKeepsItsSettings)
  {
    write("up.txt", "0 0\n1 1\n2 0\n");
    const std::string file =
      write_scene("subsection Motion\n  set Type = text\n  set File = up.txt\n"
                  "  set Vertical file = up.txt\n  set Vertical peak = 1\nend\n");
    EXPECT_EQ(read_scene(file, {"Motion/Type=none"}).motion.type, "none");
    EXPECT_NO_THROW(
      read_scene(file, {"Motion/Type=none", "Motion/Spectrum file=" + path("up.txt")}));
    EXPECT_NO_THROW(read_scene(file, {"Motion/Type=none", "Motion/Vertical file="}));
    expect_error(write_scene("subsection Motion\n  set Vertical file = up.txt\nend\n"),
                 {"Motion/Vertical file", "is not used unless Motion/Type"});
  }
} // namespace hybrid::scene::test
