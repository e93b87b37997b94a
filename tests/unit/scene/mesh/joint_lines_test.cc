// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/joint_lines.h>

#include "temporary_files.h"

namespace hybrid::scene::test
{
  TEST(JointLines, AreNamedByTheirStem)
  {
    EXPECT_TRUE(is_joint_line("joint_1"));
    EXPECT_TRUE(is_joint_line("joint_steep"));
    for (const char *name : {"joint_", "joint", "joints_1", "bedding_1", ""})
      EXPECT_FALSE(is_joint_line(name)) << name;
  }


  TEST(JointLines, KnowTheirEdgesFromBothSides)
  {
    SectionMesh mesh;
    mesh.nodes              = {{0., 0.}, {1., 0.}, {2., 0.}, {1., 1.}};
    mesh.lines["joint_a"]   = {{0, 1}, {2, 1}};
    mesh.lines["joint_b"]   = {{1, 3}};
    mesh.lines["bedding_1"] = {{0, 3}};
    const JointLines lines(mesh);
    ASSERT_NE(lines.of(1, 0), nullptr);
    EXPECT_EQ(*lines.of(1, 0), "joint_a");
    EXPECT_EQ(*lines.of(1, 2), "joint_a");
    EXPECT_EQ(*lines.of(3, 1), "joint_b");
    EXPECT_EQ(lines.of(0, 3), nullptr);
    EXPECT_EQ(lines.of(2, 3), nullptr);
  }


  TEST(JointLines, AnEdgeIsOnOneOfThem)
  {
    SectionMesh mesh;
    mesh.nodes            = {{0., 0.}, {1., 0.}};
    mesh.lines["joint_a"] = {{0, 1}};
    mesh.lines["joint_b"] = {{1, 0}};
    expect_part(message_of([&]() { JointLines(mesh).of(0, 1); }),
                "The edge at (0.5, 0) m is on two lines, joint_a and joint_b");
  }
} // namespace hybrid::scene::test
