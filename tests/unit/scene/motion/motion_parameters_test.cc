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
} // namespace hybrid::scene::test
