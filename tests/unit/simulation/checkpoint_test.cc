// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/checkpoint.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;

  const std::string parameters = "# a comment\n"
                                 "set Title = one\n"
                                 "subsection Time\n"
                                 "  set End time = 2 # default: 1\n"
                                 "  set Time step = 0.001\n"
                                 "end\n"
                                 "subsection Output\n"
                                 "  set Directory = a\n"
                                 "end\n"
                                 "subsection Materials\n"
                                 "  subsection rock\n"
                                 "    set Density = 2450 # default: 2000\n"
                                 "  end\n"
                                 "end\n";

  /// What check_same_scene() says if @p old is replaced.
  std::string complaint(const std::string &old, const std::string &replacement)
  {
    std::string changed = parameters;
    changed.replace(changed.find(old), old.size(), replacement);
    try
      {
        check_same_scene(parameters, changed);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



TEST(Checkpoint, is_due_after_steps_or_wall_time)
{
  double                      now = 100.;
  scene::CheckpointParameters intervals;
  intervals.step_interval = 10;
  intervals.wall_interval = 0.;
  const CheckpointSchedule by_steps(intervals, [&] { return now; });
  EXPECT_TRUE(by_steps.is_due(20));
  EXPECT_FALSE(by_steps.is_due(21));
  now = 1e6;
  EXPECT_FALSE(by_steps.is_due(21));

  intervals.step_interval = 0;
  intervals.wall_interval = 60.;
  CheckpointSchedule by_time(intervals, [&] { return now; });
  EXPECT_FALSE(by_time.is_due(20));
  now += 61.;
  EXPECT_TRUE(by_time.is_due(21));
  by_time.begins();
  by_time.written();
  EXPECT_FALSE(by_time.is_due(22));
  now += 61.;
  EXPECT_TRUE(by_time.is_due(23));
  by_time.begins();
  now += 10.; // to write it: the next one after 190 s
  by_time.written();
  now += 189.;
  EXPECT_FALSE(by_time.is_due(24));
  now += 2.;
  EXPECT_TRUE(by_time.is_due(25));

  intervals.wall_interval = 0.;
  const CheckpointSchedule never(intervals, [&] { return now; });
  EXPECT_FALSE(never.is_due(0));
  EXPECT_FALSE(intervals.is_on());
}



TEST(Checkpoint, only_end_time_output_and_threads_may_change)
{
  EXPECT_EQ(complaint("one", "one"), "");
  EXPECT_EQ(complaint("End time = 2 # default: 1", "End time    = 20"), "");
  EXPECT_EQ(complaint("Directory = a", "Directory = b"), "");
  EXPECT_EQ(complaint("  set Time step = 0.001", "  set Time step   = 0.001   # default: 0.1"), "");
  const std::string text = complaint("2450", "2451");
  EXPECT_NE(text.find("Materials/rock/Density = '2451'"), std::string::npos) << text;
  EXPECT_NE(text.find("'2450'"), std::string::npos) << text;
  EXPECT_NE(complaint("0.001", "0.002"), "");
  EXPECT_NE(complaint("subsection rock", "subsection clay"), "");
  EXPECT_NE(complaint("  set Time step = 0.001\n", ""), "");
}



TEST(Checkpoint, fingerprint_tells_meshes_and_motions_apart)
{
  scene::SectionMesh mesh;
  mesh.nodes         = {{0., 0.}, {1., 0.}, {0., 1.}};
  mesh.blocks        = {{0, 1, 2}};
  mesh.lines["base"] = {{{0, 1}}};
  const scene::Motion           record(0.01, {0., 1., 0.});
  const scene::MotionParameters parameters;
  const scene::GroundMotion     motion(record, parameters);
  const auto                    number = fingerprint(mesh, motion);
  EXPECT_EQ(fingerprint(mesh, motion), number);
  EXPECT_NE(fingerprint(mesh, {record.scaled(1. + 1e-15), parameters}), number);
  EXPECT_NE(fingerprint(mesh, {record, parameters, record}), number);
  auto other         = mesh;
  other.nodes[2].x() = 1e-12;
  EXPECT_NE(fingerprint(other, motion), number);
  other = mesh;
  other.lines.clear();
  EXPECT_NE(fingerprint(other, motion), number);
}
