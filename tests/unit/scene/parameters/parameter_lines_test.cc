// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_files.h"

#include <hybrid/scene/nearest_name.h>
#include <hybrid/scene/parameters/parameter_lines.h>
#include <hybrid/scene/parameters/parameter_values.h>

using namespace hybrid::scene;

using ParameterLines = test::SceneFiles;

TEST_F(ParameterLines, SettingsCarrySectionValueAndPlace)
{
  const auto lines = scan_parameter_file(write("a.prm",
                                               "# opening comment\n"
                                               "set Title = x = y # not this\n"
                                               "subsection A\r\n"
                                               "\tsubsection B C\n"
                                               "    set  Key name =  1, 2  \n"
                                               "  end\n"
                                               "end\n"));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].path(), "Title");
  EXPECT_EQ(lines[0].value, "x = y");
  EXPECT_EQ(lines[0].line, 2);
  EXPECT_EQ(lines[1].path(), "A/B C/Key name");
  EXPECT_EQ(lines[1].value, "1, 2");
  EXPECT_EQ(lines[1].line, 5);
}

TEST_F(ParameterLines, BackslashContinuesALineWhoseFirstLineCounts)
{
  const auto lines =
    scan_parameter_file(write("a.prm", "set A = 1, \\\n   2, \\\n   3\nset B = 4\n"));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].value, "1, 2, 3");
  EXPECT_EQ(lines[0].line, 1);
  EXPECT_EQ(lines[1].line, 4);
}

TEST_F(ParameterLines, IncludedLinesComeInPlaceAndInTheOpenSubsection)
{
  write("sub/b.prm", "set B = 2\ninclude c.prm\n");
  write("sub/c.prm", "set C = 3\n");
  const auto lines = scan_parameter_file(
    write("a.prm", "subsection S\n  set A = 1\n  include sub/b.prm\n  set D = 4\nend\n"));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1].path(), "S/B");
  EXPECT_EQ(lines[2].path(), "S/C");
  EXPECT_EQ(lines[2].file, path("sub/c.prm"));
  EXPECT_EQ(lines[3].line, 4);
}

TEST(ParameterValues, NumbersFillTheWholeText)
{
  EXPECT_EQ(parse_number("80.18e3").value(), 80180.);
  EXPECT_EQ(parse_number("+.5").value(), 0.5);
  EXPECT_EQ(parse_number("-2.").value(), -2.);
  for (const char *text : {"", "1 2", "1,5", "0x10", "inf", "nan", "1e999", "+-1", "--1"})
    EXPECT_FALSE(parse_number(text)) << text;
  EXPECT_FALSE(parse_integer("99999999999"));
}

TEST(ParameterValues, TextOfANumberReadsBackToTheSameBits)
{
  for (const double value : {0.1, 1. / 3., 1e-300, 9.80665, 5e-4, -1e300})
    EXPECT_EQ(parse_number(number_text(value)).value(), value);
  EXPECT_EQ(number_text(0.3025), "0.3025");
}

TEST(NearestName, SuggestsOnlySimilarNames)
{
  EXPECT_EQ(nearest_name("time step", {"End time", "Time step"}), "Time step");
  EXPECT_EQ(nearest_name("Dampingratio", {"Damping ratio", "Damping frequency"}), "Damping ratio");
  EXPECT_EQ(nearest_name("zebra", {"Time step", "Scheme"}), "");
  EXPECT_EQ(suggestion("zebra", {"Time step"}), "");
}
